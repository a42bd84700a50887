// How well a metric agrees with people on one set: in the order of the pairs, and in the shape of
// the map; what chance alone would give; and means over several sets.
//
// Source    Lim & Park 2023, section 5 and Table 2: Spearman's rho, and K between maps of three
//           dimensions. Table 2's averages are means of |rho|, an undefined rho counted as 0, a
//           failed map as K = 1.
// Input     a metric's dissimilarities and people's, of the same patterns; NaN: not rated
// Valid     K of up to 2k + 1 patterns is fragile: any ratings fit then
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/correlation.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/map/random_stress.h"

namespace tact {

struct EvaluationParams {
    int dimensions = 3;
    std::size_t rho_orders = 10'000;
    std::size_t k_orders = 5000;
    std::size_t bootstrap_draws = 2000;
    std::size_t chance_draws = 10'000;  // pairs of unrelated maps
    std::size_t stress_draws = 100;     // random orders
    // Single descents besides the best map; of these the ones with a stress of at most
    // `equal_stress` above the best fit practically as well, and show how much of K is left open.
    std::size_t spread_starts = 20;
    double equal_stress = 0.005;
    int threads = 0;  // 0: all cores
};

// A matrix with its best map and the others that fit practically as well.
struct Mapped {
    Dissimilarity dissimilarity;
    PerceptualSpace space;
    std::vector<Eigen::MatrixXd> maps;  // the best one first; none where there is no map
    // The map by published_mds_params(), for the paper's bookkeeping; 0 x 0 where mdscale gives
    // up: two patterns share a spot of its classical start, or no patterns differ.
    Eigen::MatrixXd published_map;
    bool is_failed_start = false;  // two patterns on one spot of the classical start
};

bool has_map(const PerceptualSpace& space);

// What all metrics of a set are compared with.
struct RatedSet {
    Mapped people;  // of all patterns; without ratings one lies anywhere
    AlienationChance k_chance;
    RandomStress random_stress;
    // Where some patterns have no ratings: the places of those that have, and these alone, which is
    // what counts.
    std::vector<std::size_t> rated{};
    std::shared_ptr<const RatedSet> part{};
};

// The rated patterns alone.
const RatedSet& rated_part(const RatedSet& rated);

// A matrix of all patterns, among the rated ones alone.
Dissimilarity among_rated(const Dissimilarity& all, const RatedSet& rated);

// Errors: fewer than three patterns; no order among the ratings.
Expected<RatedSet> rated_set(const Dissimilarity& ratings, const EvaluationParams& params);

// Why no metric has a K, as the map of the ratings has collapsed, or that this map is of interval
// scaling: a sentence without a full stop, to be said once for all metrics; empty: neither.
std::string remark_on_people_map(const RatedSet& rated);

// NaN: undefined, and a remark says why, or remark_on_people_map().
struct Evaluation {
    double rho = 0.0;
    Interval rho_interval;  // 95 %, if other patterns had been taken
    double rho_p = 1.0;
    double tau_b = 0.0;
    double k = 0.0;
    Interval k_spread;       // over maps that fit practically as well
    std::size_t k_maps = 0;  // pairs of such maps
    double k_p = 1.0;
    double k_corrected = 0.0;       // 1 - K / chance
    double k_procrustes = 0.0;      // another measure, not that of Table 2
    double protest_p = 1.0;         // of that
    double stress1 = 0.0;           // of the metric's map
    Eigen::MatrixXd map;            // which has the rated patterns; none: 0 x 0
    bool is_degenerate = false;     // its stress says nothing
    Eigen::MatrixXd published_map;  // by the paper's own procedure; none: 0 x 0
    bool is_failed_map = false;
    // MATLAB's mdscale gives up: its classical start has two patterns on one spot.
    bool is_failed_start = false;
    double k_published = 0.0;          // between maps by the paper's own procedure
    std::vector<std::string> remarks;  // sentences without a full stop
};

// `metric` has the patterns of the ratings, in their order; those without ratings are ignored.
Evaluation evaluate(const Dissimilarity& metric, const RatedSet& rated,
                    const EvaluationParams& params);

// Each remark once, after the keys of all metrics that it is on: "st-sim, spqi: groups of ..".
std::vector<std::string> remarks_by_metric(std::span<const std::string> keys,
                                           std::span<const Evaluation> evaluations);

// What goes into a mean over sets.
struct Agreement {
    double rho = 0.0;  // NaN: undefined
    double k = 0.0;    // NaN: the map failed
};

enum class Bookkeeping {
    plain,  // undefined ones are left out and counted
    paper   // an undefined rho is 0, a failed map K = 1
};

struct MeanAgreement {
    double signed_rho = 0.0;
    double absolute_rho =
        0.0;  // the paper's "average"; it flatters a metric that goes the wrong way
    double k = 0.0;
    std::size_t sets = 0;
    std::size_t undefined_rho = 0;
    std::size_t failed_maps = 0;
};

// NaN of no sets.
MeanAgreement mean_agreement(std::span<const Agreement> agreements, Bookkeeping bookkeeping);

// The agreement as a mean counts it: the paper's bookkeeping takes K of its own procedure, and
// counts a map as failed only where its start fails.
Agreement agreement_of(const Evaluation& evaluation, Bookkeeping bookkeeping);

}  // namespace tact
