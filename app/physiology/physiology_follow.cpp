#include "app/physiology/physiology_follow.h"

#include <utility>

#include "app/map/map_follow.h"

namespace tact {

void make_stages_jobs(const Ui& ui, Physiology& physiology) {
    using StagesJob = LatestJob<LiveStagesRequest, LiveStages>;
    for (auto* job : {&physiology.stages_job, &physiology.pinned_job}) {
        *job = std::make_unique<StagesJob>(JobPolicy::finish, compute_live_stages, ui.wake);
    }
}

void take_stages(Physiology& physiology) {
    if (!physiology.stages_job) return;
    if (auto stages = physiology.stages_job->latest()) physiology.stages = std::move(stages);
    if (auto stages = physiology.pinned_job->latest()) physiology.pinned_stages = std::move(stages);
}

void follow_current(Workspace& work, const RenderingState& rendered, Physiology& physiology) {
    const PatternSet& set = work.document.set;
    if (!physiology.stages_job || work.selection.current >= set.vibrations.size()) return;
    LiveStagesRequest request = stages_request(set, work.selection.current, rendered_by(rendered));
    if (request != physiology.stages_asked) {
        physiology.stages_asked = request;
        physiology.stages_job->submit(std::move(request));
    }
    const auto pinned = place_named(set, work.selection.pinned);
    if (!pinned) {
        work.selection.pinned.clear();
        return;
    }
    request = stages_request(set, *pinned, rendered_by(rendered));
    if (request == physiology.pinned_asked) return;
    physiology.pinned_asked = request;
    physiology.pinned_job->submit(std::move(request));
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
