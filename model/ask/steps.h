// Even steps from one vibration to another: patterns on the way between them, placed so that each
// is predicted to be as far from the next as the next is from the one after.
//
// The way is bisected where it goes farthest, the most even places are searched among all that were
// looked at, then in ever narrower windows around each, with coarse envelopes that are held against
// exact ones each time.
//
// Evenness in PM itself cannot be asked for: PM is made of ranks, neighbours are the closest pairs
// of such a set, and so their ranks are 1, 2, 3 ... whatever their distances are. What is made even
// instead is the sum that PM would be without ranks:
//
//     d_ij = w_NC NC_ij / NC_max + w_OC OC_ij / OC_max       maxima over the set of these patterns
//
// or NC or OC alone. What is told is what a prediction of that set gives, and so is the verdict;
// its PM is told beside it.
//
// Source    ours
// Valid     2 to kMostSteps patterns in all
// Exact     same input, same patterns, on any number of threads.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/pattern/pattern.h"
#include "model/pattern/pattern_parameter.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

inline constexpr std::size_t kMostSteps = 16;
inline constexpr double kEvenWithin = 0.05;

enum class StepMeasure { pm, nc, oc };

struct StepsQuestion {
    Pattern from;
    Pattern to;
    std::size_t count = 5;  // with both ends
    StepMeasure measure = StepMeasure::pm;
    PerceptualModelParams model;

    bool operator==(const StepsQuestion&) const = default;
};

struct StepsOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from this thread
};

// Where the way goes far at once, however finely it is walked.
struct PathJump {
    double share = 0.0;     // of the way
    double distance = 0.0;  // in the unit of EvenSteps::apart
};

struct EvenSteps {
    std::vector<Pattern> patterns;   // the ends bit for bit
    std::vector<double> shares;      // of the way, 0 to 1
    std::vector<double> apart;       // neighbours, in what was to be even; exact, by this set
    double ends_apart = 0.0;         // first and last, in the same
    std::vector<double> pm;          // neighbours, exact PM of the set of these
    double largest_pm = 0.0;         // of any pair of them
    double uneven = 0.0;             // largest of `apart` to smallest, less 1
    std::optional<PathJump> jump{};  // the largest there is, where they are not even
};

bool is_even(const EvenSteps& steps);

// Largest to smallest, less 1; infinity where one is 0, 0 of none.
double unevenness(const std::vector<double>& values);

// None when stopped.
std::optional<EvenSteps> even_steps(const StepsQuestion& question, const StepsOptions& options);

// How even it came out, and where the way jumps, in sentences: "Neighbours are equally far within
// 1.2 %. ..."
std::string sentence_on(const StepsQuestion& question, const EvenSteps& steps);

// The exact PM of neighbours in the set of these, and that it counts ranks.
std::string pm_sentence_on(const EvenSteps& steps);

// `from` with one number changed to that of `to`: the end of the way along a parameter. None where
// either has no such number.
std::optional<Pattern> end_along(const Pattern& from, const Pattern& to,
                                 PatternParameter parameter);

// Even steps as a document, and what is asked of them by name: of the command steps and of Python.

// {"patterns", "shares", "apart", "ends_apart", "pm", "largest_pm", "uneven", "even", "jump"}; the
// last where there is one. `names`: of the patterns.
nlohmann::json json_of(const EvenSteps& steps, const std::vector<std::string>& names);

inline constexpr const char* kStepMeasures[] = {"pm", "nc", "oc"};
std::optional<StepMeasure> step_measure_named(std::string_view name);

// `to`, or where a parameter is named, `from` with this number alone changed to that of `to`.
Expected<Pattern> end_of_way(const Pattern& from, const Pattern& to, const std::string& parameter);

// Even steps as patterns of a set: their names, and what is said of each.

// What lies between two vibrations of a set, and the end behind it where that is not one of them:
// "A to B 2", "A to B 3" .. under names that are free.
std::vector<Vibration> vibrations_between(const PatternSet& set, std::size_t from, std::size_t to,
                                          const EvenSteps& steps);

// A set of these alone, the ends among them, with the model of the first.
PatternSet set_of_steps(const PatternSet& set, std::size_t from, std::size_t to,
                        const EvenSteps& steps);

}  // namespace tact
