#include "app/map/pair.h"

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
    const Dissimilarity& pm = shown_map.transition.shown->prediction.pm;
    const auto row = place_named(mapped, work.document.set.vibrations[current].name);
    std::optional<std::size_t> closest;
    for (std::size_t k = 0; row && k < pm.size; ++k) {
        const bool closer = !closest || pm(*row, k) < pm(*row, *closest);
        if (k != *row && closer && place_named(work.document.set, mapped.vibrations[k].name)) {
            closest = k;
        }
    }
    if (closest) pair.partner = *place_named(work.document.set, mapped.vibrations[*closest].name);
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

}  // namespace tact
