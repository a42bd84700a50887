#include "model/export/loss_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/text/numbers.h"

namespace tact {

namespace {

std::string pair_with_number(const ExportLoss& loss, const ConfusablePair& pair) {
    return loss_number(pair.dissimilarity) + ", " + pair_text(loss, pair.a, pair.b);
}

const char* proof_word(const SubsetAnswer& answer) {
    switch (answer.proof) {
        case SubsetProof::optimal:
            return "proven";
        case SubsetProof::ties_open:
            return "proven but for ties";
        case SubsetProof::open:
            break;
    }
    return "the best found in time";
}

// "without a, with b": what another subset has that this one has not.
std::string exchange_of(const ExportLoss& loss, const Subset& from, const Subset& to) {
    std::vector<std::size_t> gone;
    std::vector<std::size_t> come;
    std::ranges::set_difference(from.members, to.members, std::back_inserter(gone));
    std::ranges::set_difference(to.members, from.members, std::back_inserter(come));
    return names_text(loss, come) + " in place of " + names_text(loss, gone);
}

// How much better the best one is, by what was asked for and on the scale of all other numbers. By
// the ranks among the exported patterns themselves it is better; where it is not on that scale,
// there is no number to show.
std::string gain_of(const ExportLoss& loss, const SubsetChange& change) {
    const bool by_weakest =
        change.problem.objective == SubsetObjective::max_min &&
        change.best.best.weakest_dissimilarity != change.kept.weakest_dissimilarity;
    const Subset kept = subset_of(loss.after, change.kept.members);
    const Subset best = subset_of(loss.after, change.best.best.members);
    const double from = by_weakest ? kept.weakest_dissimilarity : kept.sum;
    const double to = by_weakest ? best.weakest_dissimilarity : best.sum;
    if (!(to > from)) return ", by PM of the exported set alone";
    return std::string(": ") + (by_weakest ? "its weakest pair" : "the sum of its pairs") +
           " is at " + loss_number(to) + " in place of " + loss_number(from);
}

// Those that were picked and are left out there, as nothing of them is felt.
std::vector<std::size_t> silenced_of(const SubsetChange& change) {
    std::vector<std::size_t> picked;
    for (const std::size_t k : change.silenced) {
        const bool is_out = !std::ranges::binary_search(change.best.best.members, k);
        if (is_out && std::ranges::binary_search(change.kept.members, k)) picked.push_back(k);
    }
    return picked;
}

// "; nothing can be felt there of a, b".
std::string silenced_words(const ExportLoss& loss, const SubsetChange& change) {
    if (change.silenced.empty()) return {};
    return "; nothing can be felt there of " + names_text(loss, change.silenced);
}

}  // namespace

std::string loss_number(double value) {
    constexpr double kNothing = 1e-6;
    return std::abs(value) < kNothing ? "0" : significant_digits(value, 4);
}

std::string psnr_text(const PatternLoss& loss) {
    return loss.psnr_db ? significant_digits(*loss.psnr_db, 3) : "-";
}

std::string moved_text(const PatternLoss& loss) {
    return loss.moved ? loss_number(*loss.moved) : "-";
}

std::string pair_text(const ExportLoss& loss, std::size_t a, std::size_t b) {
    return loss.patterns[a].name + " and " + loss.patterns[b].name;
}

std::vector<BeforeAfter> before_after_rows(const ExportLoss& loss) {
    std::vector<BeforeAfter> rows;
    if (loss.closest_before && loss.closest_after) {
        rows.push_back({"closest pair", pair_with_number(loss, *loss.closest_before),
                        pair_with_number(loss, *loss.closest_after)});
    }
    if (loss.subset) {
        const Subset& meant = loss.subset->meant.best;
        const ConfusablePair before{meant.weakest.first, meant.weakest.second,
                                    meant.weakest_dissimilarity};
        rows.push_back({"weakest pair of the " + std::to_string(meant.members.size()) + " picked",
                        pair_with_number(loss, before),
                        pair_with_number(loss, loss.subset->weakest)});
    }
    if (loss.map) {
        rows.push_back({"stress-1 of the map", loss_number(loss.map->stress_before),
                        loss_number(loss.map->stress_after)});
    }
    return rows;
}

std::string names_text(const ExportLoss& loss, const std::vector<std::size_t>& members) {
    std::string text;
    for (const std::size_t member : members) {
        text += (text.empty() ? "" : ", ") + loss.patterns[member].name;
    }
    return text;
}

std::string subset_verdict(const ExportLoss& loss) {
    if (!loss.subset) return "No subset: " + loss.no_subset;
    const SubsetChange& change = *loss.subset;
    const std::string count = std::to_string(change.meant.best.members.size());
    const std::string picked = "The " + count + " most distinct, " + proof_word(change.meant) +
                               ": " + names_text(loss, change.meant.best.members);
    const std::string silent = silenced_words(loss, change);
    if (change.is_still_best) {
        return picked + ". They are still the best for this target, " + proof_word(change.best) +
               silent;
    }
    std::string text = picked + ". For this target they are not the best: " +
                       exchange_of(loss, change.kept, change.best.best) + ", " +
                       proof_word(change.best);
    if (silenced_of(change).empty()) text += gain_of(loss, change);
    return text + silent;
}

std::string summary_of(const ExportLoss& loss, std::span<const std::size_t> written) {
    std::size_t lossy = 0;
    std::size_t far = 0;
    std::size_t silenced = 0;
    for (const std::size_t place : written) {
        const PatternLoss& one = loss.patterns[place];
        if (!one.remarks.empty()) ++lossy;
        if (one.silenced) ++silenced;
        if (loss.closest_before && one.moved.value_or(0.0) > loss.closest_before->dissimilarity)
            ++far;
    }
    const std::string of = " of " + std::to_string(written.size()) +
                           (written.size() == 1 ? " pattern " : " patterns ");
    std::string text = (lossy == 0 ? "None" : std::to_string(lossy)) + of +
                       (lossy > 1 ? "lose" : "loses") + (lossy == 0 ? " anything" : " something");
    if (silenced > 0) text += "; nothing can be felt of " + std::to_string(silenced);
    if (far == 0) return text;
    return text + "; " + std::to_string(far) + (far > 1 ? " are" : " is") +
           " farther from what was meant than the closest pair is apart";
}

std::string summary_of(const ExportLoss& loss) {
    std::vector<std::size_t> written;
    for (std::size_t k = 0; k < loss.patterns.size(); ++k) {
        if (!loss.patterns[k].recording) written.push_back(k);
    }
    return summary_of(loss, written);
}

std::vector<std::size_t> written_first(const ExportLoss& loss,
                                       std::span<const std::size_t> written) {
    std::vector<std::size_t> places(written.begin(), written.end());
    for (std::size_t k = 0; k < loss.patterns.size(); ++k) {
        if (std::ranges::find(written, k) == written.end()) places.push_back(k);
    }
    return places;
}

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
