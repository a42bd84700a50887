// How far a window's content lies where nobody can scroll to it; empty: nowhere.
#pragma once

#include <imgui_internal.h>

#include <string>

namespace tact {

inline std::string out_of_reach(const ImGuiWindow& window) {
    const ImVec2 content = window.DC.CursorMaxPos - window.DC.CursorStartPos;
    const ImVec2 room = window.WorkRect.GetSize();
    const bool has_bar = (window.Flags & ImGuiWindowFlags_NoScrollbar) == 0;
    // A field of several lines follows its cursor by itself; ImGui alone makes such a window.
    const bool is_field = (window.Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
                          (window.Flags & ImGuiWindowFlags_NoMove) != 0;
    const bool is_wide = is_field || (window.Flags & ImGuiWindowFlags_HorizontalScrollbar) != 0;
    std::string faults;
    if (content.x > room.x + 1.5F && !is_wide) {
        faults += "to the right by " + std::to_string(content.x - room.x) + " px; ";
    }
    if (content.y > room.y + 1.5F && !has_bar) {
        faults += "below by " + std::to_string(content.y - room.y) + " px; ";
    }
    return faults;
}

}  // namespace tact
