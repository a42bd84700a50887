#include "model/export/loss_json.h"

#include <nlohmann/json.hpp>

namespace tact {

namespace {

nlohmann::json json_of(const ExportLoss& loss, const std::vector<std::size_t>& members) {
    nlohmann::json names = nlohmann::json::array();
    for (const std::size_t member : members) names.push_back(loss.patterns[member].name);
    return names;
}

nlohmann::json pair_json(const ExportLoss& loss, std::size_t a, std::size_t b, double pm) {
    return {{"a", loss.patterns[a].name}, {"b", loss.patterns[b].name}, {"dissimilarity", pm}};
}

nlohmann::json json_of(const ExportLoss& loss, const Subset& subset) {
    return {{"patterns", json_of(loss, subset.members)},
            {"weakest", pair_json(loss, subset.weakest.first, subset.weakest.second,
                                  subset.weakest_dissimilarity)},
            {"sum", subset.sum}};
}

nlohmann::json json_of(const ExportLoss& loss, const std::optional<ConfusablePair>& pair) {
    return pair ? pair_json(loss, pair->a, pair->b, pair->dissimilarity) : nlohmann::json();
}

nlohmann::json json_of(const EnvelopeError& error) {
    return {{"error_db", error.error_db}, {"at_s", error.at_s},
            {"meant_s", error.meant_s},   {"lasts_s", error.lasts_s},
            {"accents", error.accents},   {"accents_left", error.accents_left}};
}

nlohmann::json subset_json(const ExportLoss& loss) {
    if (!loss.subset) return {{"none", loss.no_subset}};
    const SubsetChange& change = *loss.subset;
    nlohmann::json before = json_of(loss, change.meant.best);
    before["optimal"] = change.meant.proof == SubsetProof::optimal;
    nlohmann::json best = json_of(loss, change.best.best);
    best["optimal"] = change.best.proof == SubsetProof::optimal;
    return {{"before", before},
            {"weakest_after", json_of(loss, std::optional(change.weakest))},
            {"still_best", change.is_still_best},
            {"silenced", json_of(loss, change.silenced)},
            {"exported_alone", {{"best", best}, {"kept", json_of(loss, change.kept)}}}};
}

nlohmann::json json_of(const Eigen::MatrixXd& points) {
    nlohmann::json rows = nlohmann::json::array();
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        nlohmann::json row = nlohmann::json::array();
        for (Eigen::Index k = 0; k < points.cols(); ++k) row.push_back(points(i, k));
        rows.push_back(row);
    }
    return rows;
}

nlohmann::json map_json(const ExportLoss& loss) {
    if (!loss.map) return {};
    return {{"before", json_of(loss.map->before)},
            {"after", json_of(loss.map->after)},
            {"stress1_before", loss.map->stress_before},
            {"stress1_after", loss.map->stress_after},
            {"correlation", loss.map->correlation}};
}

}  // namespace

nlohmann::json json_of(const ExportLoss& loss) {
    nlohmann::json patterns = nlohmann::json::array();
    nlohmann::json labels = nlohmann::json::array();
    for (const PatternLoss& one : loss.patterns) {
        labels.push_back(one.name);
        patterns.push_back(
            {{"pattern", one.name},
             {"recording", one.recording},
             {"rms_error_g", one.rms_error_g},
             {"psnr_db", one.psnr_db ? nlohmann::json(*one.psnr_db) : nlohmann::json()},
             {"moved", one.moved ? nlohmann::json(*one.moved) : nlohmann::json()},
             {"silenced", one.silenced},
             {"envelope", one.error ? json_of(*one.error) : nlohmann::json()},
             {"remarks", one.remarks}});
    }
    nlohmann::json moved = nlohmann::json::array();
    for (const PairChange& one : loss.most_moved) {
        moved.push_back({{"a", loss.patterns[one.a].name},
                         {"b", loss.patterns[one.b].name},
                         {"before", one.before},
                         {"after", one.after}});
    }
    return {{"labels", labels},
            {"patterns", patterns},
            {"before", loss.before.condensed},
            {"after", loss.after.condensed},
            {"closest",
             {{"before", json_of(loss, loss.closest_before)},
              {"after", json_of(loss, loss.closest_after)}}},
            {"most_moved", moved},
            {"subset", subset_json(loss)},
            {"map", map_json(loss)}};
}

}  // namespace tact
