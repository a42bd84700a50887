// Pairs that people may confuse, and the smallest change of one pattern that would part it from all
// others, or from those of a subset.
//
// PM depends on the set. Of a changed pattern it is that of the set with the change: all ranks are
// taken anew. As there are as many pairs as before, PM keeps its scale, and a threshold its
// meaning.
//
// Source    ours
// Input     an exact prediction of a set of at least two patterns
// Output    changes of one number each, tried at 1, 2, 4, 8 and 16 steps either way and narrowed by
//           halving; distances are those of the full model
// Left out  changes of several numbers at once, of the rhythm's notes and of recordings.
// Exact     same input, same changes, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/pattern/pattern_parameter.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ConfusablePair {
    std::size_t a = 0;
    std::size_t b = 0;  // > a
    double dissimilarity = 0.0;

    bool operator==(const ConfusablePair&) const = default;
};

// The pairs not above the threshold, the closest first, at most so many; none where it is no finite
// number.
std::vector<ConfusablePair> confusable_pairs(const Dissimilarity& dissimilarity, double threshold,
                                             std::size_t most);

// The dissimilarity below which a share of the pairs lies; NaN of none.
double threshold_at(const Dissimilarity& dissimilarity, double share);

// What quantiles are taken of: dissimilarities that are known, ascending.
std::vector<double> sorted_values(const Dissimilarity& dissimilarity);

// Those of some of the objects alone (ascending), in their order.
Dissimilarity among(const Dissimilarity& dissimilarity, std::span<const std::size_t> objects);

struct Separation {
    PatternParameter parameter = PatternParameter::amplitude;
    double from = 0.0;
    double to = 0.0;
    double steps = 0.0;          // size of the change, in what is felt roughly alike
    double nearest = 0.0;        // PM to the closest of the others then ...
    std::size_t nearest_to = 0;  // ... which is this one

    bool operator==(const Separation&) const = default;
};

struct SeparationOptions {
    std::vector<std::size_t> from{};  // the others that count, such as a subset's; empty: all
    int threads = 0;                  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from this thread
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
