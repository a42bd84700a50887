#include "app/subset/parts.h"

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::optional<FoundGroups> find_groups(const GroupsRequest& request, std::stop_token stop,
                                       std::atomic<float>& /*progress*/) {
    if (stop.stop_requested()) return std::nullopt;
    const Prediction& prediction = request.map->prediction;
    return FoundGroups{
        request, groups_of_set(*request.map->request.set, prediction.pm, unfelt(prediction.codes))};
}

std::size_t asked_count(const SubsetState& picking) {
    const GroupTree& tree = picking.groups->groups.tree;
    AskedGroups asked{{}, picking.cut};
    if (picking.group_count > 0) {
        asked.count = std::min(static_cast<std::size_t>(picking.group_count), tree.size);
    }
    return *asked_group_count(picking.groups->groups, asked);
}

}  // namespace

void follow_groups(const Ui& ui, const ShownMap& shown_map, const Layout& layout,
                   SubsetState& picking) {
    if (auto latest = picking.groups_job.latest()) picking.groups = std::move(latest);
    if (layout.bench != BenchTab::subset || picking.view != SubsetView::groups) return;
    picking.groups_job.want(GroupsRequest{shown_map.transition.shown}, find_groups, ui.wake);
}

const FoundGroups* shown_groups(const ShownMap& shown_map, const SubsetState& picking) {
    const FoundGroups* found = picking.groups.get();
    if (found == nullptr || !shown_map.transition.shown) return nullptr;
    const LiveMapRequest& of = found->request.map->request;
    const LiveMapRequest& shown = shown_map.transition.shown->request;
    const bool is_of_shown = of.document == shown.document &&
                             std::ranges::equal(of.set->vibrations, shown.set->vibrations, {},
                                                &Vibration::name, &Vibration::name);
    return is_of_shown ? found : nullptr;
}

const CutGroups& cut_groups(SubsetState& picking) {
    CutGroups& cut = picking.cut_groups;
    const std::size_t count = asked_count(picking);
    if (cut.of == picking.groups && cut.count == count) return cut;
    const LiveMap& map = *picking.groups->request.map;
    cut = {picking.groups,
           count,
           groups_at(picking.groups->groups, map.prediction.pm, count),
           {},
           std::vector<std::size_t>(map.prediction.pm.size, kApart)};
    std::size_t colour = 0;
    for (std::size_t k = 0; k < cut.groups.size(); ++k) {
        cut.colours.push_back(cut.groups[k].members.size() > 1 ? colour++ : kApart);
        for (const std::size_t row : cut.groups[k].members) cut.group_of[row] = k;
    }
    return cut;
}

double cut_height(const SubsetState& picking) {
    if (picking.cut) return *picking.cut;
    const GroupTree& tree = picking.groups->groups.tree;
    const auto [from, below] = cuts_of(tree, asked_count(picking));
    return std::isfinite(below) ? 0.5 * (from + below) : 1.02 * from;
}

PatternLook group_look(const Theme& theme, const CutGroups& cut, std::size_t group) {
    if (group == kApart || cut.colours[group] == kApart) return {theme.dim_text, true};
    return pattern_look(theme, cut.colours[group]);
}

void keep_groups(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    if (shown_groups(shown_map, picking) == nullptr) return;
    const CutGroups& cut = cut_groups(picking);
    PatternSet& set = work.document.edit();
    for (Vibration& vibration : set.vibrations) {
        if (picking.kept_groups.contains(vibration.name)) vibration.locked = false;
    }
    PatternSet mapped = *picking.groups->request.map->request.set;  // with the locks of now
    for (Vibration& vibration : mapped.vibrations) {
        const auto place = place_named(set, vibration.name);
        vibration.locked = place && set.vibrations[*place].locked;
    }
    picking.kept_groups.clear();
    const std::vector<std::size_t> rows = standing_for(mapped, cut.groups);
    for (const std::size_t row : rows) {
        const auto place = place_named(set, mapped.vibrations[row].name);
        if (!place || set.vibrations[*place].locked) continue;
        set.vibrations[*place].locked = true;
        set.vibrations[*place].dropped = false;
        picking.kept_groups.insert(set.vibrations[*place].name);
    }
    document_changed(work);
    commit_step(ui, work, "keep one pattern of each group");
    picking.count = static_cast<int>(std::max<std::size_t>(rows.size(), 2));
    picking.objective = SubsetObjective::max_min;
    picking.by_ratings = false;
    picking.metric = Metric::pm;
    picking.view = SubsetView::pick;
    say(ui, "Locked one pattern of each of " + counted(cut.groups.size(), "group", "groups") +
                ", or left it at the locked ones. Ctrl+Z takes it back.");
}

}  // namespace tact
