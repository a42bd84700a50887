// A box for texts that breaks its lines.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

// A text as it stands in a box: long lines are broken between words, by breaks that are not in the
// text, and what is typed there is read back without them.
//
// Units     places are bytes, at the beginnings of characters (UTF-8)
// Valid     a break stands behind a space where there is one; a word that is wider than the box is
//           broken between letters
// Exact     text_of(wrapped(text)) is the text.

struct WrappedText {
    std::string shown;                // with a line feed at every break
    std::vector<std::size_t> breaks;  // places in it of those that are not in the text, rising

    bool operator==(const WrappedText&) const = default;
};

// How many bytes of a line, which has no line feed, have room in the box; all of them where it has.
using LineRoom = std::function<std::size_t(std::string_view)>;

WrappedText wrapped(std::string_view text, const LineRoom& room);

std::string text_of(const WrappedText& wrapped);

// A place in the text for one in what is shown, and back: behind a break, where there is one.
std::size_t place_in_text(const WrappedText& wrapped, std::size_t shown_at);
std::size_t place_shown(const WrappedText& wrapped, std::size_t text_at);

// What a piece of what is shown is in the text.
std::string text_between(const WrappedText& wrapped, std::size_t from, std::size_t to);

struct EditedText {
    std::string text;
    std::size_t cursor = 0;    // in the text
    bool begins_word = false;  // its first letter was typed
};

// In what is shown: the first place of what is selected, or the cursor's; and the cursor's.
struct BoxCursor {
    std::size_t first = 0;
    std::size_t at = 0;
};

// The text after what is shown was edited to `now`, with the cursor before and after. Line feeds
// that were typed are in the text; who takes away nothing but a break, takes the letter beside it.
EditedText edited(const WrappedText& before, std::string_view now, BoxCursor cursor_before,
                  std::size_t cursor_now);

// A box for texts of several lines that breaks them at its width, which ImGui's own does not.
//
// Input     the keyboard and the mouse, as ImGui's multi-line field takes them: arrows, selection,
//           clipboard
// Output    the text, whose line feeds are those that were typed
// Left out  undo within the box: who keeps the text has it. Copies hold no breaks of the box.

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
