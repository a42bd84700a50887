// The exhaustive search for the parameters whose PM agrees best with people, over several sets.
//
//     objective = mean over the sets of Spearman's rho between PM and the ratings
//
// For each pair of layer counts two patterns have a form of whole numbers (nc_matrix.h), so that
// NC^2 is a whole number in squared steps of the weights: ranks need no root, and ties are exact.
// Ranks are counted for many mixtures of NC and OC at once (training_kernel.h). What is ranked and
// what that is compared with are apart, so leaving a set or a participant out needs no new ranks.
//
// Source    Lim & Park 2023, sections 4.3 and 5.3
// Input     forms and OC of sets, columns of ratings of their pairs; not finite: not rated
// Output    for every objective its best value and each class of combinations that reaches it
// Valid     time grows with the square of the pairs of a set: made for as many as people rate
// Exact     rho is to the bit that of the model with these parameters (rho_at). One exception: if
//           brain waveforms are so long that squared NC passes 2e8 (12 s by steps of a tenth),
//           weights in the same proportion are taken as equal, which quantisation may see
//           otherwise. Same input, same bits, on any number of threads and any instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/physiology/nc_matrix.h"
#include "model/training/training_grid.h"
#include "model/training/training_kernel.h"

namespace tact {

// Columns of ratings of the same pairs of a set.
struct RatedPairs {
    std::vector<std::size_t> pairs;                 // places in condensed order, by ascending OC
    std::vector<std::vector<std::int32_t>> column;  // twice the ranks about their mean
};

struct SearchSet {
    std::size_t samples = 0;                    // of a brain waveform
    std::vector<std::vector<SpikeForm>> forms;  // [layers][pair]
    std::vector<double> oc_rank;                // condensed
    std::vector<RatedPairs> rated;
};

// One column of ratings of one set.
struct ColumnPlace {
    std::size_t set = 0;
    std::size_t rated = 0;
    std::size_t column = 0;

    bool operator==(const ColumnPlace&) const = default;
};

struct SearchProblem {
    std::vector<SearchSet> sets;
    // The search finds the best mean over each one's columns. Marginals are kept for the first.
    std::vector<std::vector<ColumnPlace>> objectives;
};

// Adds ratings of the pairs of sets[set]; none if the rated ones have no order.
std::optional<ColumnPlace> add_ratings(SearchProblem& problem, std::size_t set,
                                       std::span<const double> condensed);

enum class TrainingObjective {
    mean_rho,
    mean_absolute_rho  // the paper's averages: it also counts orders that are wrong way round
};

struct SearchParams {
    int units = 10;  // steps of a weight between 0 and 1
    TrainingObjective objective = TrainingObjective::mean_rho;
    int threads = 0;                         // 0: all cores
    const TrainingKernel* kernel = nullptr;  // null: the one in use
    std::stop_token stop{};
    std::function<void(double)> progress{};  // share of the work done, 0..1, from any thread
};

// Values within this of the best are equal to it: what sums of rounded rhos can differ by.
inline constexpr double kEqualObjective = 1e-12;

// The first of the classes at an optimum are listed, all are counted.
inline constexpr std::size_t kMostListedPoints = 10'000;

struct SearchOptimum {
    double value = 0.0;  // NaN: no combination gives all sets an order
    std::vector<GridPoint> points;
    std::uint64_t classes = 0;
    std::uint64_t combinations = 0;  // of the grid
};

struct SearchResult {
    TrainingGrid grid;
    std::vector<SearchOptimum> optima;  // of each objective
    // Best values of the first objective; minus infinity if no combination has an order.
    std::vector<double> best_of_layers;
    std::vector<double> best_of_channel;
    std::vector<double> best_of_mix;
    std::vector<std::uint64_t> histogram;  // of all combinations with an order, see below
};

// Nothing when stopped.
std::optional<SearchResult> search(const SearchProblem& problem, const SearchParams& params);

// Share of all combinations whose objective is at most `below` under the best, to 1e-5 in value.
double share_near_best(const SearchResult& result, double below);

// Spearman's rho of PM with `model`'s trained parameters and the ratings, as the model computes it.
double rho_at(const SearchSet& set, const PerceptualModelParams& model,
              std::span<const double> condensed);

}  // namespace tact
