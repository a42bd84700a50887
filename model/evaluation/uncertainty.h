// How sure rho and K are, and the differences between metrics, if other patterns or other people
// had been taken: Table 2 as what a sample says of all.
//
// Patterns  paired bootstrap over patterns: the same are drawn for every metric, the maps stay; of
//           up to kExactObjects all ways to draw are counted in place of some
// People    jackknife: each left out once, the map of the rest made again. A bootstrap would not
//           do: drawn twice, a person's noise weighs twice, and the mean agrees less with
//           everything than that of as many people does; in simulations its intervals of rho held
//           the truth in 0 to 80 of 100 cases.
// Both      bootstrap over both at once, corrected by those over either alone (two_way_error), as
//           the plain one overstates what is not known (Owen 2007)
//
// Output    standard errors; intervals of Student's t (people less one, over both the fewer of
//           people and patterns less one) times the error, over patterns of the normal
//           distribution; p two-sided by the same
// Source    Efron 1979; Tukey 1958; Schütt et al. 2023; Holm 1979. Truth is what as many patterns
// and people would
//           have on average: noise lowers every rho, and no interval takes that back.
// Valid     rated pairs that are known of every metric. What cannot be known is NaN with its
// reason:
//           few pairs have ranks that do not move when a person or pattern goes, and an error of 0
//           would say that nothing could be surer.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/common/distributions.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dissimilarity/resampling.h"
#include "model/evaluation/evaluation.h"
#include "model/study/ratings.h"

namespace tact {

enum class Resampled { patterns, people, both };
inline constexpr std::size_t kResampledCount = 3;
inline constexpr std::array<const char*, kResampledCount> kResampledNames{"patterns", "people",
                                                                          "both"};

struct UncertaintyParams {
    std::size_t draws = 2000;
    std::size_t map_draws = 200;  // of K over both: each has a map of its own
    double coverage = 0.95;
    std::uint64_t pattern_seed = 2;  // as of bootstrap_interval()
    std::uint64_t people_seed = 8;
    int threads = 0;  // 0: all cores
};

// By what was resampled; NaN: not known.
struct Uncertain {
    double value = 0.0;
    std::array<double, kResampledCount> error{};  // standard error
    std::array<NotKnown, kResampledCount> why{};
    std::array<std::size_t, kResampledCount> freedom{};  // of Student's t; 0: normal
    std::array<Interval, kResampledCount> interval{};
};

struct MetricDifference {
    std::size_t metric = 0;                        // its place
    Uncertain rho;                                 // of the reference less that of this one
    std::array<double, kResampledCount> p{};       // NaN where rho.why tells
    std::array<double, kResampledCount> p_holm{};  // corrected for all differences
};

struct Uncertainty {
    std::size_t people = 0;
    std::vector<Uncertain> rho;  // of each metric
    std::vector<Uncertain> k;
    std::vector<MetricDifference> differences;  // none without a reference
};

// The interval of each metric's rho over patterns alone, as uncertainty() has it, for a fraction of
// the work.
std::vector<Interval> rho_intervals(const RatedSet& rated, std::span<const Dissimilarity> metrics,
                                    std::span<const Evaluation> evaluations,
                                    const UncertaintyParams& params = {});

// `evaluations` are of each metric by `rated`, the ratings of `study`. `reference`: the place of
// the metric that the others are subtracted from.
Uncertainty uncertainty(const RatingStudy& study, const RatedSet& rated,
                        std::span<const Dissimilarity> metrics,
                        std::span<const Evaluation> evaluations,
                        std::optional<std::size_t> reference, const UncertaintyParams& params = {});

}  // namespace tact
