#include "app/rendering/rendering_state.h"

#include <utility>

#include "app/rendering/rendered_set.h"

namespace tact {

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

void follow_rendering(RenderingState& state, const Vibration* vibration) {
    if (!state.job.has_begun() || vibration == nullptr) return;
    RenderingRequest request{*vibration, state.by};
    if (request == state.asked) return;
    state.asked = request;
    state.job.ask(std::move(request));
}

std::optional<RenderedBy> rendered_by(const RenderingState& state) {
    return state.on ? std::optional(state.by) : std::nullopt;
}

std::string rendered_words(const RenderingState& state) {
    return state.on ? words_on(state.by) : "";
}

}  // namespace tact
