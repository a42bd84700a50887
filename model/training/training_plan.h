// The rhos of all mixtures of NC and OC for one order of NC: what every thread of the search for
// parameters shares, and what each has of its own.
//
// Orders of NC come again: a channel is silent, layers add nothing. So those seen lately are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/training/training_search.h"

namespace tact {

// So that registers do not lie across two lines.
struct alignas(64) Line {
    std::byte bytes[64];
};

// Columns of ratings of the same pairs, as kernels take them.
struct PlannedColumns {
    std::vector<std::int32_t> oc;       // [pair], twice the rank
    std::vector<std::int32_t> ratings;  // [column][pair]
    std::vector<double> squares;        // [column]
    std::size_t first_column = 0;       // among all of the set
};

// What all threads share of a set.
struct PlannedSet {
    const SearchSet* set = nullptr;
    std::vector<std::vector<std::int32_t>> terms;  // [layers][pair][term]; none: not whole enough
    std::vector<PlannedColumns> rated;
    std::size_t columns = 0;
    bool is_narrow = true;
};

struct Plan {
    const SearchProblem* problem = nullptr;
    const SearchParams* params = nullptr;
    const TrainingKernel* kernel = nullptr;
    TrainingGrid grid;
    std::size_t mixes = 0;                // with a share of NC
    std::size_t blocks = 0;               // of kMixes of them
    std::vector<std::int32_t> nc_weight;  // [block][kMixes], filled up with the last
    std::vector<std::int32_t> oc_weight;
    std::vector<PlannedSet> sets;
};

Plan planned(const SearchProblem& problem, const SearchParams& params);

// What one thread needs of a set.
struct SetRoom {
    std::vector<Line> lines;  // of the batch of channel weights
    std::int32_t* value = nullptr;
    std::int32_t* rank = nullptr;
    std::vector<std::int32_t> nc;  // of the pairs of the set, then of the rated ones
    std::vector<std::int32_t> rated_nc;
    std::vector<std::uint64_t> below;  // [twice the rank][word]
    std::vector<std::uint64_t> mixed;  // [pair][word]
    std::vector<Line> mixes;           // values, then excesses
    std::size_t slots = 0;
    std::vector<std::int32_t> kept_rank;  // [slot][pair]; starts with 0, which is no rank
    std::vector<double> kept_rho;         // [slot][block][column][kMixes]
    const double* rho = nullptr;          // those of the order at hand
};

SetRoom room_for(const PlannedSet& planned, const Plan& plan);

// Number of lines that hold `bytes`.
std::size_t lines_of(std::size_t bytes);

// Points room.rho at the rhos of the order in room.nc, found or made.
void find_rhos(const Plan& plan, const PlannedSet& planned, SetRoom& room);

// Sum of the products; whole, so exact.
double product(std::span<const std::int32_t> a, std::span<const std::int32_t> b);

}  // namespace tact
