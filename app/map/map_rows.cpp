#include "app/map/map_rows.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace tact {

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
