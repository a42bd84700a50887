#include "app/physiology/physiology_follow.h"

#include <utility>

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

}  // namespace tact
