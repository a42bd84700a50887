// What the mouse does in a space: camera moves, clicks, and what is drawn with it. Private to the
// space view.
#pragma once

#include "viz/space/space_stage.h"

namespace tact {

// A hand is never quite still.
inline constexpr float kClickSlackPx = 4.0F;

SpaceAction read_mouse(const char* id, const Theme& theme, const Rect& pane, SpaceStage& stage,
                       SpaceCamera& camera);

// The line, box or lasso that is being drawn.
void draw_gesture(const SpaceStage& stage, const SpaceCamera& camera,
                  std::optional<std::size_t> hovered);

}  // namespace tact
