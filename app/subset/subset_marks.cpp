#include "app/subset/subset_marks.h"

#include "app/subset/groups_follow.h"
#include "app/subset/separation_follow.h"
#include "app/subset/subset_follow.h"

namespace tact {

MapMarks subset_marks(const Theme& theme, const Layout& layout, const ShownMap& shown_map,
                      SubsetState& picking) {
    MapMarks marks;
    if (layout.bench != BenchTab::subset || !shown_map.transition.shown) return marks;
    if (picking.view == SubsetView::groups) {
        if (shown_groups(shown_map, picking) == nullptr) return marks;
        const CutGroups& cut = cut_groups(picking);
        for (const std::size_t group : cut.group_of) {
            marks.looks.push_back(group_look(theme, cut, group));
        }
        return marks;
    }
    const bool confusable = picking.view == SubsetView::confusable;
    const Subset* subset = shown_subset(shown_map, picking);
    if (subset && (!confusable || picking.too_close == TooClose::picked)) {
        marks.chosen = subset->members;
    } else if (const auto opened = opened_rows(shown_map, picking); opened && confusable) {
        marks.chosen = {opened->first, opened->second};
    }
    if (confusable) {
        for (const ConfusablePair& pair : too_close_pairs(shown_map, picking).pairs) {
            marks.links.push_back({pair.a, pair.b});
        }
    }
    const Stability* stability = shown_stability(picking);
    if (picking.view == SubsetView::stability && stability &&
        picking.pick->request.map == shown_map.transition.shown) {
        marks.spread = stability->moves;
    }
    return marks;
}

std::set<std::string> too_close_names(const Layout& layout, const SubsetState& picking) {
    if (layout.bench != BenchTab::subset || picking.view != SubsetView::confusable) return {};
    if (!picking.pairs.of) return {};
    const auto& all = picking.pairs.of->request.set->vibrations;
    std::set<std::string> names;
    for (const ConfusablePair& pair : picking.pairs.pairs) {
        names.insert(all[pair.a].name);
        names.insert(all[pair.b].name);
    }
    return names;
}

}  // namespace tact
