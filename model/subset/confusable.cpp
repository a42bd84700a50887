#include "model/subset/confusable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "model/common/distributions.h"
#include "model/set/layers.h"

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

namespace {

bool same_recording(const Measurement& one, const Measurement& other) {
    return one.waveform == other.waveform || *one.waveform == *other.waveform;
}

Pattern with_gain(Pattern pattern, double gain) {
    pattern.amplitude_g *= gain;
    for (Transient& transient : pattern.transients) transient.amplitude_g *= gain;
    return pattern;
}

// The layers that sound, in order.
std::vector<const Layer*> sounding(const LayeredPattern& layered) {
    std::vector<const Layer*> all;
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        if (sounds(layered, k)) all.push_back(&layered.layers[k]);
    }
    return all;
}

// The largest difference of any layer; nothing where they are not the same kind of layers.
std::optional<FeltDifference> layers_difference(const FeltSteps& steps, const LayeredPattern& a,
                                                const LayeredPattern& b) {
    const std::vector<const Layer*> one = sounding(a);
    const std::vector<const Layer*> other = sounding(b);
    if (one.size() != other.size()) return std::nullopt;
    FeltDifference largest{0.0, true};
    for (std::size_t k = 0; k < one.size(); ++k) {
        if (one[k]->offset_s != other[k]->offset_s) return std::nullopt;
        const auto* first = std::get_if<Pattern>(&one[k]->source);
        const auto* second = std::get_if<Pattern>(&other[k]->source);
        if (first != nullptr && second != nullptr) {
            const FeltDifference own = felt_difference(steps, with_gain(*first, one[k]->gain),
                                                       with_gain(*second, other[k]->gain));
            largest.steps = std::max(largest.steps, own.steps);
            largest.same_shape = largest.same_shape && own.same_shape;
        } else if (first != nullptr || second != nullptr || one[k]->gain != other[k]->gain ||
                   !same_recording(std::get<Measurement>(one[k]->source),
                                   std::get<Measurement>(other[k]->source))) {
            return std::nullopt;
        }
    }
    return largest;
}

// Nothing where felt steps do not measure it: one is a recording, or they have other layers.
std::optional<FeltDifference> difference(const FeltSteps& steps, const VibrationSource& first,
                                         const VibrationSource& second) {
    const auto* one = std::get_if<Pattern>(&first);
    const auto* other = std::get_if<Pattern>(&second);
    if (one != nullptr && other != nullptr) return felt_difference(steps, *one, *other);
    const auto* layers = std::get_if<LayeredPattern>(&first);
    const auto* other_layers = std::get_if<LayeredPattern>(&second);
    if (layers == nullptr || other_layers == nullptr) return std::nullopt;
    return layers_difference(steps, *layers, *other_layers);
}

}  // namespace

bool within_a_step(const PatternSet& set, std::size_t a, std::size_t b) {
    const VibrationSource& first = set.vibrations[a].source;
    const VibrationSource& second = set.vibrations[b].source;
    const auto* one = std::get_if<Pattern>(&first);
    const auto* other = std::get_if<Pattern>(&second);
    // Most pairs are patterns, and told by one number.
    if (one != nullptr && other != nullptr) return within_a_step(set.felt_steps, *one, *other);
    const auto* recording = std::get_if<Measurement>(&first);
    const auto* other_recording = std::get_if<Measurement>(&second);
    if (recording != nullptr && other_recording != nullptr) {
        return same_recording(*recording, *other_recording);
    }
    const auto felt = difference(set.felt_steps, first, second);
    return felt && felt->same_shape && felt->steps < 1.0;
}

std::vector<ConfusablePair> pairs_within_a_step(const PatternSet& set,
                                                const Dissimilarity& dissimilarity) {
    // What is no pattern has no place, and is asked about in any case.
    StepSizes none;
    none.fill(std::numeric_limits<double>::quiet_NaN());
    std::vector<StepSizes> places;
    for (const Vibration& vibration : set.vibrations) {
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        places.push_back(pattern == nullptr ? none : places_in_steps(set.felt_steps, *pattern));
    }
    std::vector<ConfusablePair> pairs;
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        for (std::size_t j = i + 1; j < dissimilarity.size; ++j) {
            if (!may_be_within_a_step(places[i], places[j])) continue;
            if (within_a_step(set, i, j)) pairs.push_back({i, j, dissimilarity(i, j)});
        }
    }
    std::ranges::stable_sort(pairs, {}, &ConfusablePair::dissimilarity);
    return pairs;
}

PairVerdict pair_verdict(const PatternSet& set, std::size_t a, std::size_t b) {
    if (within_a_step(set, a, b)) return PairVerdict::same;
    const auto felt =
        difference(set.felt_steps, set.vibrations[a].source, set.vibrations[b].source);
    if (!felt) return PairVerdict::shape;
    if (felt->steps >= kClearSteps) return PairVerdict::clear;
    return felt->same_shape ? PairVerdict::close : PairVerdict::shape;
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
            return "They differ in what felt steps do not measure: rhythm, curves, transients, "
                   "layers, "
                   "or one is a recording.";
    }
    return "";
}

}  // namespace tact
