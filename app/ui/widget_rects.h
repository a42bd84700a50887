// Places of items on the screen: for Tab, for a lesson that points at one, and for tests that click
// on the real window.
//
// Input     TACTSPACE_WIDGET_RECTS, the file that is rewritten after each frame that changed
// Output    one line per item: name, left, top, right, bottom in pixels, then its value
#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/tab_order.h"
#include "viz/drawing/geometry.h"

namespace tact {

struct WidgetRects {
    std::filesystem::path file;  // empty: no file is written
    TabOrder tab_order;
    std::string watched;  // the place of each name in this frame
    std::optional<Rect> watched_at;
    std::string lines;
    std::string written;
};

// The file named by the environment.
WidgetRects widget_rects_wanted();

void note_rect(WidgetRects& rects, const std::string& name, ImVec2 min, ImVec2 max,
               const std::string& value = {});

// Notes the rectangle of the last ImGui item.
void note_item(WidgetRects& rects, const std::string& name, const std::string& value = {});

// Ends a frame: rewrites the file if any place or value changed.
void write_rects(WidgetRects& rects);

}  // namespace tact
