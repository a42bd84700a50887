// A box for texts of several lines that breaks them at its width, which ImGui's own does not.
//
// Input     the keyboard and the mouse, as ImGui's multi-line field takes them: arrows, selection,
//           clipboard
// Output    the text, whose line feeds are those that were typed
// Left out  undo within the box: who keeps the text has it. Copies hold no breaks of the box.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>

#include "app/writing/wrapped_text.h"

namespace tact {

inline constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

// The box that is written in; one at a time.
struct TextBox {
    ImGuiID id = 0;  // 0: no box is written in
    WrappedText wrapped;
    std::size_t cursor = 0;    // in what is shown ...
    std::size_t select_a = 0;  // ... as is the selection
    std::size_t select_b = 0;
    std::size_t edited_at = kNowhere;  // in the text: where the last edit ended
    bool begins_word = false;          // by what was typed last, or it was typed elsewhere
};

// As high as its lines, of which it shows `least` to `most`. True when the text was changed.
bool draw_text_box(TextBox& box, const char* id, int least, int most, std::string& text);

}  // namespace tact
