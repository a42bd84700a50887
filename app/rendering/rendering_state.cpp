#include "app/rendering/rendering_state.h"

#include <atomic>
#include <stop_token>
#include <utility>

#include "app/rendering/rendered_set.h"

namespace tact {

namespace {

std::optional<LiveRendering> compute_live_rendering(const RenderingRequest& request,
                                                    std::stop_token stop,
                                                    std::atomic<float>& progress) {
    LiveRendering live;
    live.request = request;
    live.intended = waveform_of(request.vibration);
    live.rendering = rendering(request.by, live.intended);
    if (stop.stop_requested()) return std::nullopt;
    progress = 1.0F;
    return live;
}

}  // namespace

void follow_rendering(const Ui& ui, RenderingState& state, const Vibration* vibration) {
    if (!has_jobs(ui) || vibration == nullptr) return;
    RenderingRequest request{*vibration, state.by};
    if (request == state.asked) return;
    state.asked = request;
    state.job.ask(std::move(request), compute_live_rendering, ui.wake, JobPolicy::finish);
}

void take_rendering(RenderingState& state) {
    if (auto answer = state.job.latest()) state.shown = std::move(answer);
}

std::optional<RenderedBy> rendered_by(const RenderingState& state) {
    return state.on ? std::optional(state.by) : std::nullopt;
}

std::string rendered_words(const RenderingState& state) {
    return state.on ? words_on(state.by) : "";
}

}  // namespace tact
