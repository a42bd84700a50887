#include "app/physiology/physiology_follow.h"

#include <utility>

namespace tact {

void make_stages_jobs(App& app) {
    using StagesJob = LatestJob<LiveStagesRequest, LiveStages>;
    for (auto* job : {&app.stages_job, &app.pinned_job}) {
        *job = std::make_unique<StagesJob>(JobPolicy::finish, compute_live_stages, app.wake);
    }
}

void take_stages(App& app) {
    if (!app.stages_job) return;
    if (auto stages = app.stages_job->latest()) app.stages = std::move(stages);
    if (auto stages = app.pinned_job->latest()) app.pinned_stages = std::move(stages);
}

void follow_current(App& app) {
    const PatternSet& set = app.document.set;
    if (!app.stages_job || app.selection.current >= set.vibrations.size()) return;
    LiveStagesRequest request =
        stages_request(set, app.selection.current, rendered_by(app.rendering));
    if (request != app.stages_asked) {
        app.stages_asked = request;
        app.stages_job->submit(std::move(request));
    }
    const auto pinned = place_named(set, app.pinned);
    if (!pinned) {
        app.pinned.clear();
        return;
    }
    request = stages_request(set, *pinned, rendered_by(app.rendering));
    if (request == app.pinned_asked) return;
    app.pinned_asked = request;
    app.pinned_job->submit(std::move(request));
}

}  // namespace tact
