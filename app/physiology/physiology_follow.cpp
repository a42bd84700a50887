#include "app/physiology/physiology_follow.h"

#include <utility>

#include "app/map/map_follow.h"

namespace tact {

void take_stages(Physiology& physiology) {
    if (auto stages = physiology.stages_job.latest()) physiology.stages = std::move(stages);
    if (auto stages = physiology.pinned_job.latest()) physiology.pinned_stages = std::move(stages);
}

void follow_current(const Ui& ui, Workspace& work, const RenderingState& rendered,
                    Physiology& physiology) {
    const PatternSet& set = work.document.set;
    if (work.selection.current >= set.vibrations.size()) return;
    const auto want = [&](auto& job, std::size_t place) {
        if (!has_jobs(ui)) return;
        job.want(stages_request(set, place, rendered_by(rendered)), compute_live_stages, ui.wake,
                 JobPolicy::finish);
    };
    want(physiology.stages_job, work.selection.current);
    const auto pinned = place_named(set, work.selection.pinned);
    if (!pinned) return work.selection.pinned.clear();
    want(physiology.pinned_job, *pinned);
}

void follow_pair(const Workspace& work, const ShownMap& shown_map, Physiology& physiology) {
    physiology.view.pair_oc.reset();
    const auto pinned = place_named(work.document.set, work.selection.pinned);
    const std::size_t current = work.selection.current;
    if (!pinned || *pinned == current || map_state(work, shown_map) != MapState::exact) return;
    const Dissimilarity& oc = shown_map.transition.shown->prediction.oc;
    if (*pinned < oc.size && current < oc.size) physiology.view.pair_oc = oc(current, *pinned);
}

}  // namespace tact
