#include "model/evaluation/uncertainty.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/common/distributions.h"
#include "model/common/parallel.h"
#include "model/dissimilarity/correlation.h"
#include "model/dissimilarity/permutation.h"

namespace tact {

namespace {

using Eigen::MatrixXd;
using Places = std::vector<std::size_t>;
using Row = std::vector<double>;  // one value a metric

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// What is resampled, of the rated patterns alone.
struct Sample {
    std::size_t patterns = 0;
    std::vector<std::vector<double>> people;  // condensed, of each participant
    std::vector<double> mean;                 // of all of them
    std::vector<Dissimilarity> metrics;
    std::vector<MatrixXd> maps;  // of the metrics; none: 0 x 0
    MatrixXd people_map;         // none: 0 x 0
    MdsParams mds;
};

// One row of rho and one of K, and how often it comes.
struct Resample {
    Row rho;
    Row k;
    double weight = 1.0;
};

Places all_of(std::size_t count) {
    Places places(count);
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

std::vector<double> mean_over(const Sample& sample, const Places& people) {
    std::vector<double> mean(sample.mean.size());
    std::vector<double> values(people.size());
    for (std::size_t p = 0; p < mean.size(); ++p) {
        for (std::size_t v = 0; v < people.size(); ++v) values[v] = sample.people[people[v]][p];
        mean[p] = mean_known(values);
    }
    return mean;
}

// Pairs of drawn patterns that are rated and known of all metrics. A pattern and its copy are no
// pair.
Places pairs_of(const Sample& sample, const Places& patterns, std::span<const double> ratings) {
    Places pairs;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        for (std::size_t j = i + 1; j < patterns.size(); ++j) {
            const auto [a, b] = std::minmax(patterns[i], patterns[j]);
            if (a == b) continue;
            const std::size_t pair = pair_index(sample.patterns, a, b);
            const bool known = std::ranges::all_of(sample.metrics, [pair](const auto& metric) {
                return std::isfinite(metric.condensed[pair]);
            });
            if (known && std::isfinite(ratings[pair])) pairs.push_back(pair);
        }
    }
    return pairs;
}

std::vector<double> ranks_at(std::span<const double> values, const Places& pairs) {
    std::vector<double> taken(pairs.size());
    std::ranges::transform(pairs, taken.begin(), [values](std::size_t p) { return values[p]; });
    return centred_ranks(taken);
}

Row rhos(const Sample& sample, const Places& pairs, std::span<const double> ratings) {
    const std::vector<double> said = ranks_at(ratings, pairs);
    Row row;
    for (const Dissimilarity& metric : sample.metrics) {
        row.push_back(rho_of_ranks(ranks_at(metric.condensed, pairs), said));
    }
    return row;
}

// The people's map, from the best one of all people on: as one of the same patterns, it is near.
MatrixXd people_map_of(const Sample& sample, const std::vector<double>& ratings) {
    if (sample.people_map.size() == 0) return {};
    const PerceptualSpace space = smacof({sample.patterns, ratings}, sample.people_map, sample.mds);
    return has_map(space) ? space.points : MatrixXd();
}

MatrixXd rows_of(const MatrixXd& map, const Places& patterns) {
    MatrixXd rows(static_cast<Eigen::Index>(patterns.size()), map.cols());
    for (std::size_t k = 0; k < patterns.size(); ++k) {
        rows.row(static_cast<Eigen::Index>(k)) = map.row(static_cast<Eigen::Index>(patterns[k]));
    }
    return rows;
}

// A pattern and its copy lie on one spot in both maps, which K does not see.
Row ks(const Sample& sample, const Places& patterns, const MatrixXd& people_map) {
    Row row(sample.maps.size(), kUnknown);
    if (people_map.size() == 0) return row;
    const MatrixXd people = rows_of(people_map, patterns);
    for (std::size_t m = 0; m < row.size(); ++m) {
        if (sample.maps[m].size() == 0) continue;
        const auto k = alienation(rows_of(sample.maps[m], patterns), people);
        if (k) row[m] = *k;
    }
    return row;
}

// Without people and maps.
Sample sample_of(const RatedSet& rated, std::span<const Dissimilarity> metrics) {
    const RatedSet& part = rated_part(rated);
    Sample sample;
    sample.patterns = part.people.dissimilarity.size;
    sample.mean = part.people.dissimilarity.condensed;
    for (const Dissimilarity& metric : metrics) {
        sample.metrics.push_back(among_rated(metric, rated));
    }
    return sample;
}

Sample sample_of(const RatingStudy& study, const RatedSet& rated,
                 std::span<const Dissimilarity> metrics, std::span<const Evaluation> evaluations) {
    const RatedSet& part = rated_part(rated);
    Sample sample = sample_of(rated, metrics);
    for (Judgement& said : participant_means(study)) {
        sample.people.push_back(
            among_rated({study.labels.size(), std::move(said.condensed)}, rated).condensed);
    }
    for (const Evaluation& one : evaluations) sample.maps.push_back(one.map);
    if (!part.people.maps.empty()) {
        sample.people_map = part.people.maps.front();
        sample.mds =
            standard_mds_params(sample.patterns, static_cast<int>(sample.people_map.cols()));
        sample.mds.tolerance = 1e-7;  // far below what another person changes
        sample.mds.is_interval = part.people.space.is_interval;
    }
    return sample;
}

struct Resamples {
    std::size_t pattern_count = 0;
    std::vector<Resample> patterns;
    std::vector<Resample> people;  // each left out once
    std::vector<Resample> drawn;   // people with replacement, of all patterns
    std::vector<Resample> both;    // the same people, of drawn patterns; K of the first ones only
};

// Drawn patterns, with the people as they are.
std::vector<Resample> pattern_resamples(const Sample& sample, const UncertaintyParams& params) {
    const std::vector<ObjectDraw> draws =
        object_draws(sample.patterns, params.draws, params.pattern_seed);
    std::vector<Resample> resamples(draws.size());
    parallel_for(draws.size(), params.threads, {}, [&](std::size_t draw) {
        const auto& [patterns, weight] = draws[draw];
        resamples[draw] = {rhos(sample, pairs_of(sample, patterns, sample.mean), sample.mean),
                           ks(sample, patterns, sample.people_map), weight};
    });
    return resamples;
}

Resamples resampled(const Sample& sample, const UncertaintyParams& params) {
    const std::size_t people = sample.people.size() > 1 ? sample.people.size() : 0;
    const std::vector<Resample> none(people > 0 ? params.draws : 0);
    Resamples result{sample.patterns, pattern_resamples(sample, params),
                     std::vector<Resample>(people), none, none};
    const Places everything = all_of(sample.patterns);
    parallel_for(result.both.size(), params.threads, {}, [&](std::size_t draw) {
        const Places patterns = drawn_objects(sample.patterns, params.pattern_seed, draw);
        const auto said = mean_over(sample, drawn_objects(people, params.people_seed, draw));
        Resample& drawn = result.drawn[draw];
        Resample& both = result.both[draw];
        drawn.rho = rhos(sample, pairs_of(sample, everything, said), said);
        both.rho = rhos(sample, pairs_of(sample, patterns, said), said);
        if (draw >= params.map_draws) return;
        const MatrixXd map = people_map_of(sample, said);
        drawn.k = ks(sample, everything, map);
        both.k = ks(sample, patterns, map);
    });
    parallel_for(people, params.threads, {}, [&](std::size_t left_out) {
        Places others = all_of(people);
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
        const auto said = mean_over(sample, others);
        result.people[left_out] = {rhos(sample, pairs_of(sample, everything, said), said),
                                   ks(sample, everything, people_map_of(sample, said))};
    });
    return result;
}

// The degrees of freedom of Student's t; 0: the normal distribution. Over both they are those of
// the fewer of the two, as rsatoolbox has it.
std::size_t freedom_of(Resampled by, const Resamples& resamples) {
    const std::size_t people = resamples.people.size();
    if (by == Resampled::patterns || people < 2) return 0;
    return (by == Resampled::people ? people : std::min(people, resamples.pattern_count)) - 1;
}

// `of` takes a number out of an outcome.
template <class Of>
Uncertain uncertain(double value, Interval limits, const Resamples& resamples,
                    const UncertaintyParams& params, Of of) {
    const auto column = [&of](const std::vector<Resample>& resamples_by) {
        std::vector<Weighed> outcomes;
        for (const Resample& one : resamples_by) {
            const std::optional<double> number = of(one);
            if (number) outcomes.push_back({*number, one.weight});
        }
        return outcomes;
    };
    const bool is_alone = resamples.people.empty();
    const StandardError of_patterns = bootstrap_error(column(resamples.patterns));
    const std::array<StandardError, kResampledCount> errors{
        of_patterns, jackknife_error(column(resamples.people)),
        is_alone ? StandardError{kUnknown, NotKnown::one_person}
                 : two_way_error(bootstrap_error(column(resamples.both)), of_patterns,
                                 bootstrap_error(column(resamples.drawn)))};
    Uncertain result;
    result.value = value;
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        result.error[r] = errors[r].value;
        result.why[r] = std::isnan(value) ? NotKnown::no_value : errors[r].why;
        result.freedom[r] = freedom_of(static_cast<Resampled>(r), resamples);
        result.interval[r] =
            interval_about(value, result.error[r], params.coverage, result.freedom[r], limits);
    }
    return result;
}

std::optional<double> at(const Row& row, std::size_t place) {
    return place < row.size() ? std::optional(row[place]) : std::nullopt;
}

bool rank_alike(const Sample& sample, std::size_t a, std::size_t b) {
    const Places pairs = pairs_of(sample, all_of(sample.patterns), sample.mean);
    return ranks_at(sample.metrics[a].condensed, pairs) ==
           ranks_at(sample.metrics[b].condensed, pairs);
}

MetricDifference difference(std::size_t reference, std::size_t metric, bool are_alike,
                            std::span<const Evaluation> evaluations, const Resamples& resamples,
                            const UncertaintyParams& params) {
    MetricDifference result;
    result.metric = metric;
    result.rho = uncertain(evaluations[reference].rho - evaluations[metric].rho, {-2.0, 2.0},
                           resamples, params, [&](const Resample& outcome) {
                               return std::optional(outcome.rho[reference] - outcome.rho[metric]);
                           });
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        if (result.rho.why[r] == NotKnown::still && are_alike) result.rho.why[r] = NotKnown::alike;
        result.p[r] =
            result.rho.why[r] == NotKnown::known
                ? two_sided_p(result.rho.value / result.rho.error[r], result.rho.freedom[r])
                : kUnknown;
    }
    return result;
}

void correct(std::vector<MetricDifference>& differences) {
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        std::vector<double> p;
        for (const MetricDifference& one : differences) p.push_back(one.p[r]);
        const std::vector<double> corrected = holm(p);
        for (std::size_t k = 0; k < p.size(); ++k) differences[k].p_holm[r] = corrected[k];
    }
}

}  // namespace

std::vector<Interval> rho_intervals(const RatedSet& rated, std::span<const Dissimilarity> metrics,
                                    std::span<const Evaluation> evaluations,
                                    const UncertaintyParams& params) {
    const Sample sample = sample_of(rated, metrics);
    const Resamples resamples{sample.patterns, pattern_resamples(sample, params), {}, {}, {}};
    std::vector<Interval> intervals;
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        const Uncertain rho = uncertain(evaluations[m].rho, {-1.0, 1.0}, resamples, params,
                                        [m](const Resample& one) { return at(one.rho, m); });
        intervals.push_back(rho.interval[static_cast<std::size_t>(Resampled::patterns)]);
    }
    return intervals;
}

Uncertainty uncertainty(const RatingStudy& study, const RatedSet& rated,
                        std::span<const Dissimilarity> metrics,
                        std::span<const Evaluation> evaluations,
                        std::optional<std::size_t> reference, const UncertaintyParams& params) {
    assert(metrics.size() == evaluations.size() && "an evaluation of each metric");
    const Sample sample = sample_of(study, rated, metrics, evaluations);
    const Resamples resamples = resampled(sample, params);
    Uncertainty result;
    result.people = resamples.people.size();
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        result.rho.push_back(uncertain(evaluations[m].rho, {-1.0, 1.0}, resamples, params,
                                       [m](const Resample& one) { return at(one.rho, m); }));
        result.k.push_back(uncertain(evaluations[m].k, {0.0, 1.0}, resamples, params,
                                     [m](const Resample& one) { return at(one.k, m); }));
        if (!reference || *reference == m) continue;
        result.differences.push_back(difference(*reference, m, rank_alike(sample, *reference, m),
                                                evaluations, resamples, params));
    }
    correct(result.differences);
    return result;
}

}  // namespace tact
