// A text as it stands in a box: long lines are broken between words, by breaks that are not in the
// text, and what is typed there is read back without them.
//
// Units     places are bytes, at the beginnings of characters (UTF-8)
// Valid     a break stands behind a space where there is one; a word that is wider than the box is
//           broken between letters
// Exact     text_of(wrapped(text)) is the text.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

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

}  // namespace tact
