#include "app/ui/widget_rects.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <imgui_internal.h>

namespace tact {

WidgetRects widget_rects_wanted() {
    const char* file = std::getenv("TACTSPACE_WIDGET_RECTS");
    WidgetRects rects;
    if (file != nullptr) rects.file = file;
    return rects;
}

void note_rect(WidgetRects& rects, const std::string& name, ImVec2 min, ImVec2 max,
               const std::string& value) {
    if (!rects.watched.empty() && name == rects.watched) rects.watched_at = Rect{min, max};
    if (rects.file.empty()) return;
    // In its first frame, a list that opens is only measured, at another place.
    if (ImGui::GetCurrentWindowRead()->Hidden) return;
    const auto pixel = [](float position) { return std::to_string(static_cast<int>(position)); };
    std::string line = value;
    std::ranges::replace(line, '\n', ' ');
    rects.lines += name + "\t" + pixel(min.x) + "\t" + pixel(min.y) + "\t" + pixel(max.x) + "\t" +
                   pixel(max.y) + "\t" + line + "\n";
}

void note_item(WidgetRects& rects, const std::string& name, const std::string& value) {
    note_stop(rects.tab_order);
    note_rect(rects, name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), value);
}

void write_rects(WidgetRects& rects) {
    if (rects.file.empty()) return;
    if (ImGui::IsMousePosValid())
        note_rect(rects, "pointer", ImGui::GetMousePos(), ImGui::GetMousePos());
    if (rects.lines != rects.written) {
        // Renamed into place, so that a reader never sees half a file.
        std::filesystem::path fresh = rects.file;
        fresh += ".new";
        std::ofstream(fresh) << rects.lines;
        std::error_code ignored;
        std::filesystem::rename(fresh, rects.file, ignored);
    }
    rects.written = std::exchange(rects.lines, {});
}

}  // namespace tact
