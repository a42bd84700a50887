#include "app/command_line/loss_output.h"

#include <nlohmann/json.hpp>

#include "app/command_line/text_table.h"
#include "model/export/loss_words.h"
#include "model/text/shown_text.h"

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

std::string patterns_text(const ExportLoss& loss) {
    std::vector<TextRow> rows{{"pattern", "RMS error, g", "PSNR, dB", "PM from what was meant"}};
    for (const PatternLoss& one : loss.patterns) {
        if (one.recording) continue;
        rows.push_back({one.name, loss_number(one.rms_error_g), psnr_text(one), moved_text(one)});
    }
    return aligned(rows);
}

std::string set_text(const ExportLoss& loss) {
    std::vector<TextRow> rows{{"PM", "as it was meant", "as it comes back"}};
    for (const BeforeAfter& row : before_after_rows(loss)) {
        rows.push_back({row.what, row.before, row.after});
    }
    if (rows.size() == 1) return {};
    return "\n" + aligned(rows) + kAfterScale + "\n";
}

std::string pairs_text(const ExportLoss& loss) {
    if (loss.most_moved.empty()) return {};
    std::vector<TextRow> rows{{"pairs that moved most", "PM before", "after"}};
    for (const PairChange& one : loss.most_moved) {
        rows.push_back(
            {pair_text(loss, one.a, one.b), loss_number(one.before), loss_number(one.after)});
    }
    return "\n" + aligned(rows);
}

}  // namespace

std::string text_of(const ExportLoss& loss) {
    return "\n" + summary_of(loss) + "\n\n" + patterns_text(loss) + set_text(loss) +
           pairs_text(loss) + "\n" + shown_text(subset_verdict(loss)) + "\n";
}

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
