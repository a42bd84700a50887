// What differs between Dear ImGui 1.86 (Debian 12) and 1.90 (Debian 13): nothing else asks for a
// version. Written for the newer one, whose names the older one is given here.
//
// Left out  1.92, whose fonts are sized at run time and whose texture grows (fonts.cpp)
#pragma once

#include <imgui.h>
// After imgui.h.
#include <imgui_internal.h>

#include <algorithm>
#include <span>

namespace tact {

#if IMGUI_VERSION_NUM < 19000

// Keys without a name there have the first numbers behind those that have one.
// NOLINTBEGIN(readability-identifier-naming): the newer version's own names
inline constexpr ImGuiKey ImGuiKey_KeypadEnter = ImGuiKey_KeyPadEnter;
inline constexpr ImGuiKey ImGuiKey_T = ImGuiKey_COUNT;
inline constexpr ImGuiKey ImGuiKey_F1 = ImGuiKey_COUNT + 1;
// NOLINTEND(readability-identifier-naming)
inline constexpr ImGuiKey kSpaceBar = ImGuiKey_COUNT + 2;  // its own name presses buttons

// Once per context, before its first frame: keys are known by their names.
inline void name_keys(ImGuiIO& io) {
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
}

// A key of the coming frame.
inline void add_key(ImGuiIO& io, ImGuiKey key, bool down) { io.KeysDown[key] = down; }

inline void add_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt, bool super) {
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyAlt = alt;
    io.KeySuper = super;
}

// The wheel turns what was drawn last, and scrolls no pane, from the next frame on. True: in this
// one, too.
inline bool take_wheel() {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    imgui.HoveredIdUsingMouseWheel = true;
    return imgui.HoveredIdPreviousFrameUsingMouseWheel;
}

// What is drawn next has the keyboard from the next frame on.
inline void focus_next_item() { ImGui::SetKeyboardFocusHere(); }

// The lists stay whose they are, and must outlive the frame.
inline void set_draw_lists(ImDrawData& frame, std::span<ImDrawList*> lists) {
    frame.CmdLists = lists.data();
    frame.CmdListsCount = static_cast<int>(lists.size());
}

#else

// The space bar, whose own name presses buttons, goes by that of a key that nothing else means.
inline constexpr ImGuiKey kSpaceBar = ImGuiKey_F12;

// Which events share a frame is app/screen/screen's word, not ImGui's.
inline void name_keys(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }

inline void add_key(ImGuiIO& io, ImGuiKey key, bool down) { io.AddKeyEvent(key, down); }

inline void add_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt, bool super) {
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(ImGuiMod_Alt, alt);
    io.AddKeyEvent(ImGuiMod_Super, super);
}

inline bool take_wheel() {
    const bool is_taken = ImGui::GetKeyOwner(ImGuiKey_MouseWheelY) != ImGuiKeyOwner_None;
    ImGui::SetKeyOwner(ImGuiKey_MouseWheelY, ImGui::GetID("wheel"));
    return is_taken;
}

// 1.90.1 looks for the item only where the keyboard was last: in this window, it is told.
inline void focus_next_item() {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    imgui.NavFocusScopeId = imgui.CurrentFocusScopeId;
    ImGui::SetKeyboardFocusHere();
}

inline void set_draw_lists(ImDrawData& frame, std::span<ImDrawList*> lists) {
    frame.CmdLists.resize(static_cast<int>(lists.size()));
    std::ranges::copy(lists, frame.CmdLists.begin());
    frame.CmdListsCount = frame.CmdLists.Size;
}

#endif

}  // namespace tact
