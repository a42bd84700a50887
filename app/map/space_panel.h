// The perceptual space of the set, following the document.
#pragma once

#include <cstddef>
#include <optional>

#include "app/map/map_look.h"
#include "app/window/app.h"

namespace tact {

// What the person did in the map, for the frame to act on: rows of the document.
struct SpacePaneAction {
    std::optional<std::size_t> hovered{};
    std::optional<std::size_t> double_clicked{};
};

SpacePaneAction draw_space_panel(App& app, const MapMarks& marks);

}  // namespace tact
