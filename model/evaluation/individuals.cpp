#include "model/evaluation/individuals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "model/common/mean.h"
#include "model/common/parallel.h"

namespace tact {

namespace {

// The means of participants, or the passes of the only one, as people of their own.
RatingStudy voices_of(const RatingStudy& study) {
    RatingStudy voices{study.labels, study.is_named, participant_means(study)};
    if (voices.judgements.size() > 1) return voices;
    voices.judgements = study.judgements;
    for (std::size_t k = 0; k < voices.judgements.size(); ++k) {
        voices.judgements[k].participant += ", pass " + std::to_string(k + 1);
    }
    return voices;
}

struct VoiceBounds {
    double with_others = 0.0;
    double with_all = 0.0;
};

std::vector<VoiceBounds> bounds_of(const RatingStudy& voices) {
    const std::vector<double> all = mean_ratings(voices).condensed;
    const std::vector<VoiceAgreement> others = agreement_with_others(voices);
    std::vector<VoiceBounds> bounds;
    for (std::size_t k = 0; k < others.size(); ++k) {
        bounds.push_back({others[k].rho, spearman(voices.judgements[k].condensed, all)});
    }
    return bounds;
}

bool is_complete(std::span<const double> values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// A column of a table that has a row a person.
Spread column_spread(const std::vector<PersonAgreement>& people,
                     std::vector<double> PersonAgreement::*column, std::size_t metric) {
    std::vector<double> values;
    for (const PersonAgreement& person : people) values.push_back((person.*column)[metric]);
    return spread_of(values);
}

// Empty where the ratings make no map, or are too few for one.
Eigen::MatrixXd map_of(const Dissimilarity& ratings, const EvaluationParams& params) {
    if (!is_complete(ratings.condensed)) return {};
    MdsParams mds = standard_mds_params(ratings.size, params.dimensions);
    mds.threads = 1;  // people are shared among the threads
    const PerceptualSpace space = nonmetric_mds(ratings, mds);
    return has_map(space) ? space.points : Eigen::MatrixXd();
}

}  // namespace

Spread spread_of(std::span<const double> values) {
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double value) { return !std::isnan(value); });
    std::ranges::sort(known);
    return {mean_known(known), quantile(known, 0.5), quantile(known, 0.25), quantile(known, 0.75),
            known.size()};
}

Ceilings ceilings(const RatingStudy& study, const Reliability& reliability) {
    Ceilings result{reliability.voices,
                    reliability.is_of_one_person,
                    reliability.spearman_brown,
                    reliability.ceiling_of_mean,
                    {},
                    {}};
    std::vector<double> others;
    std::vector<double> all;
    for (const VoiceBounds& one : bounds_of(voices_of(study))) {
        others.push_back(one.with_others);
        all.push_back(one.with_all);
    }
    result.with_others = spread_of(others);
    result.with_all = spread_of(all);
    return result;
}

Individuals individuals(const RatingStudy& study, const RatedSet& rated,
                        std::span<const Dissimilarity> metrics,
                        std::span<const Evaluation> evaluations, const EvaluationParams& params) {
    assert(metrics.size() == evaluations.size() && "an evaluation of each metric");
    const RatingStudy voices{study.labels, study.is_named, participant_means(study)};
    const std::vector<VoiceBounds> bounds = bounds_of(voices);
    Individuals result;
    result.people.resize(bounds.size());
    parallel_for(bounds.size(), params.threads, {}, [&](std::size_t p) {
        const Judgement& said = voices.judgements[p];
        PersonAgreement& person = result.people[p];
        person = {said.participant, bounds[p].with_others, bounds[p].with_all, {}, {}};
        const Eigen::MatrixXd own =
            map_of(among_rated({study.labels.size(), said.condensed}, rated), params);
        for (std::size_t m = 0; m < metrics.size(); ++m) {
            person.rho.push_back(spearman(metrics[m].condensed, said.condensed));
            const auto k = alienation(own, evaluations[m].map);
            person.k.push_back(k ? *k : kNoRating);
        }
    });
    for (std::size_t m = 0; m < metrics.size() && !bounds.empty(); ++m) {
        result.rho.push_back(column_spread(result.people, &PersonAgreement::rho, m));
        result.k.push_back(column_spread(result.people, &PersonAgreement::k, m));
    }
    return result;
}

}  // namespace tact
