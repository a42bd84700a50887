// The response of an actuator to full scale: g over frequency, both logarithmic.
//
// Input     the table by ascending frequency, and tones too distorted or too faint for it
// Output    the point of the table under the mouse
// Left out  phase.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

struct ResponseMark {
    double frequency_hz = 0.0;
    double g = 0.0;  // per full scale; values up to 0 are not drawn
};

struct ResponseScene {
    std::span<const ResponseMark> table{};
    std::span<const ResponseMark> refused{};  // rings in the warning colour
};

struct ResponseAction {
    std::optional<std::size_t> hovered{};  // index into the table
};

ResponseAction draw_response(const char* id, const Theme& theme, const Rect& area,
                             const ResponseScene& scene);

}  // namespace tact
