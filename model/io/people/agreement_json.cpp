#include "model/io/people/agreement_json.h"

#include <nlohmann/json.hpp>

namespace tact {

namespace {

nlohmann::json json_of(const Uncertain& value) {
    nlohmann::json json;
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        json[kResampledNames[r]] = {{"se", value.error[r]},
                                    {"low", value.interval[r].low},
                                    {"high", value.interval[r].high}};
        if (value.why[r] != NotKnown::known)
            json[kResampledNames[r]]["not_known"] = words(value.why[r]);
    }
    return json;
}

nlohmann::json json_of(const Spread& spread) {
    return {{"mean", spread.mean},
            {"median", spread.median},
            {"quartiles", {spread.low, spread.high}},
            {"known", spread.known}};
}

// What is beyond the metric's own evaluation.
void add_resampled(nlohmann::json& json, const MetricTable& table, std::size_t m) {
    json["rho_resampled"] = json_of(table.uncertainty.rho[m]);
    json["K_resampled"] = json_of(table.uncertainty.k[m]);
    for (const MetricDifference& one : table.uncertainty.differences) {
        if (one.metric != m) continue;
        json["pm_less_this"] = json_of(one.rho);
        json["pm_less_this"]["rho"] = one.rho.value;
        for (std::size_t r = 0; r < kResampledCount; ++r) {
            json["pm_less_this"][kResampledNames[r]]["p"] = one.p[r];
            json["pm_less_this"][kResampledNames[r]]["p_holm"] = one.p_holm[r];
        }
    }
    if (!table.individuals.people.empty()) {
        json["rho_person"] = json_of(table.individuals.rho[m]);
        json["K_person"] = json_of(table.individuals.k[m]);
    }
    for (const Given& one : table.given) {
        const PartialRho& partial = one.metrics[m];
        json["given"][one.name] = {{"rho", partial.rho},
                                   {"low", partial.interval.low},
                                   {"high", partial.interval.high},
                                   {"rho_alone", one.rho_alone}};
    }
}

}  // namespace

nlohmann::json json_of(const RatedTable& rated, std::size_t metric, Bookkeeping books) {
    const Evaluation& e = rated.table.evaluations[metric];
    const RatedPeople& people = rated.people;
    nlohmann::json json{{"rho", e.rho},
                        {"rho_low", e.rho_interval.low},
                        {"rho_high", e.rho_interval.high},
                        {"p", e.rho_p},
                        {"tau_b", e.tau_b},
                        {"K", agreement_of(e, books).k},
                        {"K_low", e.k_spread.low},
                        {"K_high", e.k_spread.high},
                        {"K_chance", rated_part(people.rated).k_chance.mean},
                        {"K_p", e.k_p},
                        {"K_corrected", e.k_corrected},
                        {"K_procrustes", e.k_procrustes},
                        {"protest_p", e.protest_p},
                        {"stress1", e.stress1},
                        {"reliability", people.reliability.spearman_brown},
                        {"one_with_others", people.reliability.one_with_others},
                        {"ceiling_of_mean", people.reliability.ceiling_of_mean},
                        {"ceiling_person_lower", json_of(people.ceilings.with_others)},
                        {"ceiling_person_upper", json_of(people.ceilings.with_all)},
                        {"participants", people.participants},
                        {"synthetic", people.mark.synthetic},
                        {"unrated_patterns", people.unrated},
                        {"remarks", e.remarks}};
    add_to(json, rated.raters);
    add_resampled(json, rated.table, metric);
    return json;
}

void add_to(nlohmann::json& json, const InterRater& raters) {
    json["icc_single"] = raters.single.value;
    json["icc_single_low"] = raters.single.interval.low;
    json["icc_single_high"] = raters.single.interval.high;
    json["icc_mean"] = raters.mean.value;
    json["icc_mean_low"] = raters.mean.interval.low;
    json["icc_mean_high"] = raters.mean.interval.high;
    json["icc_pairs"] = raters.pairs;
    json["alpha"] = raters.alpha;
    json["alpha_pairs"] = raters.alpha_pairs;
}

}  // namespace tact
