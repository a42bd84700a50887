#include "app/physiology/physiology_follow.h"

#include <utility>

#include "app/map/map_follow.h"

namespace tact {

void make_stages_jobs(const Ui& ui, Physiology& physiology) {
    for (auto* job : {&physiology.stages_job, &physiology.pinned_job}) {
        job->begin(JobPolicy::finish, compute_live_stages, ui.wake);
    }
}

void take_stages(Physiology& physiology) {
    if (auto stages = physiology.stages_job.latest()) physiology.stages = std::move(stages);
    if (auto stages = physiology.pinned_job.latest()) physiology.pinned_stages = std::move(stages);
}

void follow_current(Workspace& work, const RenderingState& rendered, Physiology& physiology) {
    const PatternSet& set = work.document.set;
    if (work.selection.current >= set.vibrations.size()) return;
    physiology.stages_job.want(stages_request(set, work.selection.current, rendered_by(rendered)));
    const auto pinned = place_named(set, work.selection.pinned);
    if (!pinned) return work.selection.pinned.clear();
    physiology.pinned_job.want(stages_request(set, *pinned, rendered_by(rendered)));
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
