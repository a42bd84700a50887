// What a kind of device makes of the patterns, computed in the background: its report on the
// current one, and whether all that is predicted is of what the device plays.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/jobs/query.h"
#include "app/ui/ui.h"
#include "devices/calibration/rendering.h"
#include "model/set/pattern_set.h"

namespace tact {

struct RenderingRequest {
    Vibration vibration;
    RenderedBy by;

    bool operator==(const RenderingRequest&) const = default;
};

struct LiveRendering {
    RenderingRequest request;
    Waveform intended;
    Rendering rendering;
};

struct RenderingState {
    bool on = false;  // maps, matrices and stages are of what the device plays
    RenderedBy by;
    bool at_bar_level = false;  // else as at full level
    Query<RenderingRequest, LiveRendering> job;
    RenderingRequest asked;
    std::shared_ptr<const LiveRendering> shown;  // of the current vibration, or of one before it
};

// Asks for the report on a vibration (may be null) unless it was asked for last.
void follow_rendering(const Ui& ui, RenderingState& state, const Vibration* vibration);

// Takes the newest report.
void take_rendering(RenderingState& state);

// None while predictions are of the patterns as they were meant.
std::optional<RenderedBy> rendered_by(const RenderingState& state);

// "as a Joy-Con plays them, uncalibrated"; empty while it is off.
std::string rendered_words(const RenderingState& state);

}  // namespace tact
