#include "app/command_line/agreement/agreement.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "app/compare/compare.h"
#include "assets/assets.h"
#include "model/dissimilarity/correlation.h"
#include "model/io/set/set_file.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/study/ratings.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

PatternSet bundled(const std::string& path) {
    Expected<PatternSet> set = parse_set(asset(path), path, {});
    assert(set && "a compiled-in set does not parse");
    return *std::move(set);
}

// The sets on which models are judged, with everything that does not depend on the model.
struct Judges {
    std::vector<Waveform> morse;
    Dissimilarity ratings;
    std::vector<Waveform> twelve;
    Prediction published;  // PM of the twelve patterns
    Eigen::MatrixXd map;   // the map of that matrix
};

Eigen::MatrixXd map_of(const Dissimilarity& matrix, int threads) {
    MdsParams params = standard_mds_params(matrix.size, 3);
    params.threads = threads;
    return nonmetric_mds(matrix, params).points;
}

std::optional<VariantOutcome> judged(const ModelVariant& variant, const Judges& judges,
                                     const VariantOptions& options) {
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    VariantOutcome outcome;
    outcome.name = variant.name;
    outcome.model = variant.model;
    const auto morse = predict(judges.morse, variant.model, how);
    const auto twelve = predict(judges.twelve, variant.model, how);
    CheckOptions check;
    check.threads = options.threads;
    check.model = variant.model;
    check.stop = options.stop;
    const auto found = check_findings(check);
    if (!morse || !twelve || !found) return std::nullopt;
    BootstrapParams bootstrap;
    bootstrap.threads = options.threads;
    outcome.morse_pm = spearman(morse->pm.condensed, judges.ratings.condensed);
    outcome.morse_interval = bootstrap_interval(morse->pm, judges.ratings, bootstrap);
    outcome.morse_oc = spearman(morse->oc.condensed, judges.ratings.condensed);
    outcome.oc_values = distinct_values(morse->oc);
    for (const Finding& one : *found) {
        if (one.status == FindingStatus::holds) ++outcome.hold;
        if (one.status == FindingStatus::fails) outcome.failing.push_back(one.id);
    }
    outcome.twelve_rho = spearman(twelve->pm.condensed, judges.published.pm.condensed);
    const auto k = alienation(map_of(twelve->pm, options.threads), judges.map);
    outcome.twelve_k = k ? *k : std::numeric_limits<double>::quiet_NaN();
    return outcome;
}

}  // namespace

std::vector<ModelVariant> model_variants() {
    std::vector<ModelVariant> all{{"as published", {}}};
    for (const double cost : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
        ModelVariant one{"waiting costs " + significant_digits(cost, 2), {}};
        one.model.envelope.waiting_cost = cost;
        all.push_back(one);
    }
    ModelVariant aosp{"thresholds of AOSP", {}};
    aosp.model.coding.tables.threshold = aosp_thresholds();
    all.push_back(aosp);
    aosp.name += ", waiting costs 0.1";
    aosp.model.envelope.waiting_cost = 0.1;
    all.push_back(aosp);
    return all;
}

std::optional<std::vector<VariantOutcome>> check_variants(const VariantOptions& options) {
    const PatternSet morse = bundled(kMorseSet);
    const PatternSet twelve = bundled(std::string("sets/") + kTwelveSet + ".tactspace.json");
    const Expected<RatingStudy> study = study_of(morse);
    assert(study && "the set has its ratings");
    Judges judges;
    judges.morse = own_waveforms(morse, options.threads);
    judges.ratings = mean_ratings(*study);
    judges.twelve = own_waveforms(twelve, options.threads);
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    auto published = predict(judges.twelve, {}, how);
    if (!published) return std::nullopt;
    judges.published = *std::move(published);
    judges.map = map_of(judges.published.pm, options.threads);
    const std::vector<ModelVariant> variants = model_variants();
    std::vector<VariantOutcome> outcomes;
    for (const ModelVariant& variant : variants) {
        auto outcome = judged(variant, judges, options);
        if (!outcome) return std::nullopt;
        outcomes.push_back(*std::move(outcome));
        if (options.progress) {
            options.progress(static_cast<double>(outcomes.size()) /
                             static_cast<double>(variants.size()));
        }
    }
    return outcomes;
}

const VariantOutcome& chosen_by_morse(std::span<const VariantOutcome> all) {
    return *std::ranges::max_element(all, {}, &VariantOutcome::morse_pm);
}

const VariantOutcome& chosen_by_findings(std::span<const VariantOutcome> all) {
    return *std::ranges::max_element(all, {}, &VariantOutcome::hold);
}

}  // namespace tact
