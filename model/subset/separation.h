// Pairs that people may confuse, and the smallest change of one pattern that would part it from all
// others, or from those of a subset.
//
// PM depends on the set. PM of a changed pattern is that of the set with the change: all ranks are
// taken again. As the number of pairs stays, PM keeps its scale, and a threshold its meaning.
//
// Source    ours
// Input     an exact prediction of a set of at least two patterns
// Output    changes of one number each, by whole steps that are felt (model/pattern/felt_steps.h):
//           the smallest number of them found, of at most 16 either way; distances are those of the
//           full model
// Left out  changes of several numbers at once, of the rhythm's notes and of recordings.
// Exact     same input, same changes, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/pattern/pattern_parameter.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/subset/confusable.h"

namespace tact {

struct Separation {
    PatternParameter parameter = PatternParameter::amplitude;
    double from = 0.0;
    double to = 0.0;
    double steps = 0.0;          // size of the change, in felt steps; at least 1
    double nearest = 0.0;        // PM to the closest of the others then ...
    std::size_t nearest_to = 0;  // ... which is this one

    bool operator==(const Separation&) const = default;
};

struct SeparationOptions {
    std::vector<std::size_t> from{};  // the others that count, such as a subset's; empty: all
    // Share of the closest pairs, of those that count, if it sets the threshold, which is then
    // taken again in the set with the change.
    std::optional<double> share{};
    // No other that counts may be within a felt step then, besides what PM says.
    bool by_a_step = false;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from this thread
    // s. Where it ends the search, `cut_off` is called, and what is given is what was confirmed
    // till then: smaller changes may exist.
    double time_limit_s = std::numeric_limits<double>::infinity();
    std::function<void()> cut_off{};
    // What is felt of a vibration, as long as it is: where a device plays it. None: itself. The
    // prediction is then of what is felt, too.
    std::function<Waveform(const Waveform&)> felt{};
};

// Changes of the pattern at a place that bring its PM to all others that count above the threshold,
// the smallest first. None when stopped, and for a recording; an empty list where the threshold is
// no finite number.
std::optional<std::vector<Separation>> separations(const PatternSet& set,
                                                   const Prediction& prediction, std::size_t place,
                                                   double threshold,
                                                   const SeparationOptions& options = {});

}  // namespace tact
