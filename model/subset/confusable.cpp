#include "model/subset/confusable.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/common/quantile.h"

namespace tact {

std::vector<ConfusablePair> confusable_pairs(const Dissimilarity& dissimilarity, double threshold,
                                             std::size_t most) {
    if (!std::isfinite(threshold)) return {};
    std::vector<ConfusablePair> pairs;
    std::size_t k = 0;
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        for (std::size_t j = i + 1; j < dissimilarity.size; ++j, ++k) {
            const double value = dissimilarity.condensed[k];
            if (value <= threshold) pairs.push_back({i, j, value});
        }
    }
    // A few hundred of half a million pairs are wanted.
    const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(std::min(most, pairs.size()));
    std::ranges::partial_sort(pairs, end, {}, [](const ConfusablePair& pair) {
        return std::tuple(pair.dissimilarity, pair.a, pair.b);
    });
    pairs.erase(end, pairs.end());
    return pairs;
}

std::vector<double> sorted_values(const Dissimilarity& dissimilarity) {
    std::vector<double> values;
    for (const double value : dissimilarity.condensed) {
        if (std::isfinite(value)) values.push_back(value);
    }
    std::ranges::sort(values);
    return values;
}

double threshold_at(const Dissimilarity& dissimilarity, double share) {
    return quantile(sorted_values(dissimilarity), share);
}

bool within_a_step(const PatternSet& set, std::size_t a, std::size_t b) {
    const auto& first = set.vibrations[a].source;
    const auto& second = set.vibrations[b].source;
    const auto* one = std::get_if<Pattern>(&first);
    const auto* other = std::get_if<Pattern>(&second);
    if (one != nullptr && other != nullptr) return within_a_step(set.felt_steps, *one, *other);
    if (one != nullptr || other != nullptr) return false;
    return *std::get<Measurement>(first).waveform == *std::get<Measurement>(second).waveform;
}

std::vector<ConfusablePair> pairs_within_a_step(const PatternSet& set,
                                                const Dissimilarity& dissimilarity) {
    std::vector<ConfusablePair> pairs;
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        for (std::size_t j = i + 1; j < dissimilarity.size; ++j) {
            if (within_a_step(set, i, j)) pairs.push_back({i, j, dissimilarity(i, j)});
        }
    }
    std::ranges::stable_sort(pairs, {}, &ConfusablePair::dissimilarity);
    return pairs;
}

PairVerdict pair_verdict(const PatternSet& set, std::size_t a, std::size_t b) {
    if (within_a_step(set, a, b)) return PairVerdict::same;
    const auto* one = std::get_if<Pattern>(&set.vibrations[a].source);
    const auto* other = std::get_if<Pattern>(&set.vibrations[b].source);
    if (one == nullptr || other == nullptr) return PairVerdict::shape;
    const FeltDifference difference = felt_difference(set.felt_steps, *one, *other);
    if (difference.steps >= kClearSteps) return PairVerdict::clear;
    return difference.same_shape ? PairVerdict::close : PairVerdict::shape;
}

const char* words_of(PairVerdict verdict) {
    switch (verdict) {
        case PairVerdict::same:
            return "same";
        case PairVerdict::close:
            return "may be confused";
        case PairVerdict::clear:
            return "clear";
        case PairVerdict::shape:
            return "differ in shape";
    }
    return "";
}

const char* sentence_of(PairVerdict verdict) {
    switch (verdict) {
        case PairVerdict::same:
            return "No number differs by a felt step, and nothing but numbers differs.";
        case PairVerdict::close:
            return "No number differs by two felt steps, and nothing but numbers differs.";
        case PairVerdict::clear:
            return "A number differs by two felt steps or more.";
        case PairVerdict::shape:
            return "They differ in what felt steps do not measure: rhythm, curves, transients, or "
                   "one is a recording.";
    }
    return "";
}

}  // namespace tact
