// A small drawing as SVG.
#pragma once

#include <functional>
#include <string>

#include "viz/picture/svg.h"

namespace tact {

// A picture of 200 x 100 px.
inline std::string drawn_svg(const std::function<void(ImDrawList&, const Theme&)>& draw) {
    return draw_svg(200, 100, {},
                    [&](const Theme& theme) { draw(*ImGui::GetWindowDrawList(), theme); });
}

}  // namespace tact
