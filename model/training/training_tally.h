// What one thread of the search for parameters has found, and all of them together.
//
// Exact     a sum of tallies is the same in any order and however the work was shared out.
#pragma once

#include <span>
#include <vector>

#include "model/training/training_search.h"

namespace tact {

struct SearchTally {
    std::vector<SearchOptimum> optima;
    std::vector<double> best_of_layers;
    std::vector<double> best_of_channel;
    std::vector<double> best_of_mix;
    std::vector<std::uint64_t> histogram;
};

SearchTally empty_tally(const TrainingGrid& grid, std::size_t objectives);

// The values of an objective at `first` and the mixtures after it.
void take_values(SearchTally& tally, const TrainingGrid& grid, std::size_t objective,
                 GridPoint first, std::span<const double> values);

void merge_into(SearchTally& all, SearchTally other);

SearchResult result_of(const TrainingGrid& grid, SearchTally all);

}  // namespace tact
