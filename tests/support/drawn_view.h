// A view of viz, drawn by itself: its picture, what was done in it, where its parts are.
#pragma once

#include "tests/support/headless_window.h"
#include "viz/picture/picture.h"

namespace tact {

template <class Action, class Layout>
struct DrawnView {
    Image image;
    Action action;
    Layout layout;
    int vertices = 0;
};

// 10 px are left around the area. `draw` and `layout_of` are called with the theme.
template <class Action, class Layout, class Draw, class LayoutOf>
DrawnView<Action, Layout> drawn_view(const PictureOptions& options, const Rect& area,
                                     const Draw& draw, const LayoutOf& layout_of) {
    DrawnView<Action, Layout> result;
    const auto side = [](float end) { return static_cast<int>(end + 10.0F); };
    result.image =
        draw_picture(side(area.max.x), side(area.max.y), options, [&](const Theme& theme) {
            result.action = draw(theme);
            result.layout = layout_of(theme);
            result.vertices = ImGui::GetWindowDrawList()->VtxBuffer.Size;
        });
    return result;
}

}  // namespace tact
