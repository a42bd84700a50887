#include "model/ask/parted_pair.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

namespace {

// All that count, the two among them; empty: all.
std::vector<std::size_t> counted_places(const PairToPart& pair) {
    std::vector<std::size_t> places = pair.among;
    if (places.empty()) return places;
    for (const std::size_t place : {pair.a, pair.b}) places.push_back(place);
    std::ranges::sort(places);
    const auto [first, last] = std::ranges::unique(places);
    places.erase(first, last);
    return places;
}

double threshold_of(const PairToPart& pair, const Dissimilarity& pm,
                    const std::vector<std::size_t>& counted) {
    if (pair.threshold) return *pair.threshold;
    const double share = threshold_at(counted.empty() ? pm : among(pm, counted), pair.share);
    return std::max(share, pm(pair.a, pair.b));
}

}  // namespace

std::vector<std::size_t> changeable_of(const PatternSet& set, std::size_t a, std::size_t b,
                                       const std::string& name) {
    std::vector<std::size_t> places;
    for (const std::size_t place : {a, b}) {
        const Vibration& vibration = set.vibrations[place];
        const bool is_wanted = name.empty() ? !vibration.locked : vibration.name == name;
        if (is_wanted && std::holds_alternative<Pattern>(vibration.source)) places.push_back(place);
    }
    return places;
}

std::optional<PartedPair> parted_pair(const PatternSet& meant, const PatternSet& felt,
                                      const PairToPart& pair, const PartingOptions& options) {
    const auto told = [&options](const std::string& what) {
        return options.progress_of ? options.progress_of(what) : std::function<void(double)>();
    };
    PredictOptions predicting;
    predicting.threads = options.threads;
    predicting.stop = options.stop;
    predicting.progress = told("comparing pairs");
    const auto prediction = predict(own_waveforms(felt, options.threads), meant.model, predicting);
    if (!prediction) return std::nullopt;
    const std::vector<std::size_t> counted = counted_places(pair);
    PartedPair result{pair.a,
                      pair.b,
                      prediction->pm(pair.a, pair.b),
                      threshold_of(pair, prediction->pm, counted),
                      {}};
    SeparationOptions separating;
    separating.from = counted;
    if (!pair.threshold) separating.share = pair.share;
    separating.threads = options.threads;
    separating.stop = options.stop;
    separating.felt = options.felt;
    separating.time_limit_s = options.time_limit_s;
    separating.cut_off = [&result] { result.is_cut_off = true; };
    for (const std::size_t place : pair.changeable) {
        separating.progress = told("changing " + meant.vibrations[place].name);
        const auto found = separations(meant, *prediction, place, result.threshold, separating);
        if (!found) return std::nullopt;
        for (const Separation& one : *found) result.changes.push_back({place, one});
    }
    std::ranges::stable_sort(result.changes, {},
                             [](const PartingChange& change) { return change.separation.steps; });
    return result;
}

nlohmann::json json_of(const PartedPair& parted, const std::vector<std::string>& names) {
    nlohmann::json json{{"pair", {names[parted.a], names[parted.b]}},
                        {"dissimilarity", parted.dissimilarity},
                        {"threshold", parted.threshold},
                        {"changes", nlohmann::json::array()}};
    if (parted.is_cut_off) json["cut_off"] = true;
    for (const auto& [place, one] : parted.changes) {
        json["changes"].push_back(
            {{"pattern", names[place]},
             {"parameter", traits(one.parameter).key},
             {"from", one.from},
             {"to", one.to},
             {"felt_steps", one.steps},
             {"nearest", {{"pattern", names[one.nearest_to]}, {"dissimilarity", one.nearest}}}});
    }
    return json;
}

}  // namespace tact
