// Where things are on the screen: for Tab, for a lesson that points at one, and for a test that
// clicks on the real window.
//
// Input     TACTSPACE_WIDGET_RECTS, the file that is rewritten after each frame that changed
// Output    one line a thing: name, left, top, right, bottom in pixels, then its value
#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/tab_order.h"
#include "viz/drawing/geometry.h"

namespace tact {

struct WidgetRects {
    std::filesystem::path file;  // empty: none is written
    TabOrder tab_order;
    std::string watched;  // a name: where its widget is in this frame
    std::optional<Rect> watched_at;
    std::string lines;
    std::string written;
};

// From the environment.
WidgetRects widget_rects_wanted();

void note_rect(WidgetRects& rects, const std::string& name, ImVec2 min, ImVec2 max,
               const std::string& value = {});

// The rectangle of the last ImGui item.
void note_item(WidgetRects& rects, const std::string& name, const std::string& value = {});

// Ends a frame: rewrites the file if anything moved.
void write_rects(WidgetRects& rects);

}  // namespace tact
