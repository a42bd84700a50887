#include "app/map/map.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "app/document/editing.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

std::optional<ChosenPair> chosen_pair(const Workspace& work, const ShownMap& shown_map) {
    const std::size_t count = work.document.set.vibrations.size();
    const std::size_t current = work.selection.current;
    if (count < 2 || current >= count) return std::nullopt;
    const auto partner = place_named(work.document.set, work.selection.partner);
    if (partner && partner != current) return ChosenPair{current, *partner, PartnerKind::chosen};
    const auto pinned = place_named(work.document.set, work.selection.pinned);
    if (pinned && pinned != current) return ChosenPair{current, *pinned, PartnerKind::pinned};
    return closest_pair(work, shown_map);
}

std::optional<ChosenPair> closest_pair(const Workspace& work, const ShownMap& shown_map) {
    const std::size_t count = work.document.set.vibrations.size();
    const std::size_t current = work.selection.current;
    if (count < 2 || current >= count) return std::nullopt;
    ChosenPair pair{current, current == 0 ? 1U : 0U, PartnerKind::closest};
    if (!shown_map.transition.shown) return pair;
    const PatternSet& mapped = *shown_map.transition.shown->request.set;
    const LiveMap& map = *shown_map.transition.shown;
    const Dissimilarity& pm = map.prediction.pm;
    const auto row = place_named(mapped, work.document.set.vibrations[current].name);
    if (!row || *row >= map.nearest.size()) return pair;
    const auto here = [&](std::size_t k) {
        return place_named(work.document.set, mapped.vibrations[k].name);
    };
    const bool is_felt = map.nearest[*row].exists_for(*row);
    std::size_t closest = map.nearest[*row].place;
    if (!is_felt || !here(closest)) {
        // Another one, as that one is gone; or any, for one that nobody feels.
        std::optional<std::size_t> other;
        for (std::size_t k = 0; k < pm.size; ++k) {
            if (k == *row || !here(k) || (is_felt && !map.nearest[k].exists_for(k))) continue;
            if (!other || pm(*row, k) < pm(*row, *other)) other = k;
        }
        if (!other) return pair;
        closest = *other;
    }
    pair.partner = *here(closest);
    return pair;
}

std::optional<std::pair<std::size_t, std::size_t>> rows_in_map(const Workspace& work,
                                                               const ShownMap& shown_map,
                                                               const ChosenPair& pair) {
    const PatternSet& mapped = *shown_map.transition.shown->request.set;
    const auto& all = work.document.set.vibrations;
    const auto a = place_named(mapped, all[pair.current].name);
    const auto b = place_named(mapped, all[pair.partner].name);
    if (!a || !b) return std::nullopt;
    return std::pair{*a, *b};
}

namespace {

struct SimilarOne {
    std::size_t place = 0;  // in the document
    double pm = 0.0;
};

std::vector<SimilarOne> closest_to(const Workspace& work, const ShownMap& shown_map,
                                   std::size_t row) {
    const LiveMap& map = *shown_map.transition.shown;
    const auto& mapped = map.request.set->vibrations;
    std::vector<SimilarOne> all;
    for (std::size_t k = 0; k < mapped.size(); ++k) {
        const auto place = place_named(work.document.set, mapped[k].name);
        if (k != row && place) all.push_back({*place, map.prediction.pm(row, k)});
    }
    std::ranges::stable_sort(all, {}, &SimilarOne::pm);
    if (all.size() > kSimilarOnes) all.resize(kSimilarOnes);
    return all;
}

}  // namespace

void select_similar(Ui& ui, Workspace& work, const ShownMap& shown_map, std::size_t place) {
    const auto& all = work.document.set.vibrations;
    const auto& shown = shown_map.transition.shown;
    const auto row = shown ? place_named(*shown->request.set, all[place].name) : std::nullopt;
    if (!row) return say(ui, "It is not in the map yet.");
    const std::vector<SimilarOne> similar = closest_to(work, shown_map, *row);
    if (similar.empty()) return say(ui, "There is no other pattern.");
    select_only(work, place);
    std::string text = "Closest to " + all[place].name + ": ";
    for (const SimilarOne& one : similar) {
        work.selection.others.insert(one.place);
        text += (&one == &similar.front() ? "" : ", ") + all[one.place].name + " (" +
                significant(one.pm) + ")";
    }
    const bool preview = map_state(work, shown_map) != MapState::exact;
    say(ui, text + ", in PM" + (preview ? " of a preview." : "."));
}

RowPlaces places_in_document(const Workspace& work, const ShownMap& shown_map) {
    const auto& shown = shown_map.transition.shown->request.set->vibrations;
    const auto& now = work.document.set.vibrations;
    RowPlaces places(shown.size());
    std::unordered_map<std::string_view, std::size_t> by_name;
    for (std::size_t k = 0; k < now.size(); ++k) by_name.emplace(now[k].name, k);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const bool in_place = k < now.size() && now[k].name == shown[k].name;
        if (in_place) {
            places[k] = k;
        } else if (const auto found = by_name.find(shown[k].name); found != by_name.end()) {
            places[k] = found->second;
        }
    }
    return places;
}

bool shows_another_set(const Workspace& work, const ShownMap& shown_map) {
    if (!shown_map.transition.shown) return false;
    const LiveMapRequest& request = shown_map.transition.shown->request;
    if (request.document != work.document_number) return true;
    if (request.revision == work.revision) return false;
    const auto& shown = shown_map.transition.shown->request.set->vibrations;
    const auto& now = work.document.set.vibrations;
    std::unordered_set<std::string_view> names;
    for (const Vibration& one : now) names.insert(one.name);
    return std::ranges::none_of(
        shown, [&names](const Vibration& one) { return names.contains(one.name); });
}

std::vector<std::size_t> rows_selected_too(const Workspace& work, const RowPlaces& places) {
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] && work.selection.others.contains(*places[k])) rows.push_back(k);
    }
    return rows;
}

}  // namespace tact
