// Sets as the search for parameters takes them, with spikes at random.
#pragma once

#include <cmath>
#include <vector>

#include "model/common/random.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/training/training_search.h"

namespace tact {

// Forms of spikes that differ here and there; with few `differences` NC often ties.
inline SpikeForm random_form(RandomStream& random, int differences) {
    SpikeForm form{};
    for (int k = 0; k < differences; ++k) {
        PerReceptor<std::int64_t> sign{};
        for (auto& of_channel : sign)
            of_channel = static_cast<std::int64_t>(next_index(random, 3)) - 1;
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            for (std::size_t d = 0; d < kReceptorCount; ++d) form[c][d] += sign[c] * sign[d];
        }
    }
    return form;
}

inline SearchSet random_set(RandomStream& random, std::size_t patterns, int differences) {
    SearchSet set;
    set.samples = 10'000;
    const std::size_t pairs = pair_count(patterns);
    set.forms.resize(kTrainedLayers);
    for (auto& forms : set.forms) {
        for (std::size_t k = 0; k < pairs; ++k) forms.push_back(random_form(random, differences));
    }
    std::vector<double> oc;
    for (std::size_t k = 0; k < pairs; ++k) {
        oc.push_back(static_cast<double>(next_index(random, pairs)));
    }
    set.oc_rank = average_ranks(oc);
    return set;
}

// With ties; infinite, not rated, for a share of the pairs.
inline std::vector<double> random_ratings(RandomStream& random, std::size_t pairs,
                                          double unrated = 0.0) {
    std::vector<double> ratings;
    for (std::size_t k = 0; k < pairs; ++k) {
        const bool is_rated = next_even(random) >= 2.0 * unrated - 1.0;
        const auto value = static_cast<double>(next_index(random, 21));
        ratings.push_back(is_rated ? 5.0 * value : INFINITY);
    }
    return ratings;
}

}  // namespace tact
