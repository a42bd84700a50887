// Lines that are broken in a box: what is typed between the breaks is in the text, breaks are not.
#include "app/writing/writing.h"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <string>
#include <utility>

namespace wrapped_text_test {

using namespace tact;

namespace {

// A line of this many bytes, broken behind the last space that has room.
LineRoom room_for(std::size_t letters) {
    return [letters](std::string_view line) {
        if (line.size() <= letters) return line.size();
        const std::size_t space = line.substr(0, letters + 1).rfind(' ');
        return space == std::string_view::npos || space == 0 ? letters : space;
    };
}

// As a key press does it in what is shown.
struct Box {
    WrappedText wrapped;
    std::size_t letters;
    std::size_t cursor = 0;

    void apply(std::string now, std::size_t cursor_now) {
        const EditedText after = edited(wrapped, now, {cursor, cursor}, cursor_now);
        wrapped = tact::wrapped(after.text, room_for(letters));
        cursor = place_shown(wrapped, after.cursor);
    }
    void type(const std::string& text) {
        std::string now = wrapped.shown;
        now.insert(cursor, text);
        apply(now, cursor + text.size());
    }
    void backspace() {
        std::string now = wrapped.shown;
        now.erase(cursor - 1, 1);
        apply(now, cursor - 1);
    }
    void remove() {
        std::string now = wrapped.shown;
        now.erase(cursor, 1);
        apply(now, cursor);
    }
    std::string text() const { return text_of(wrapped); }
};

std::string random_text(std::mt19937& random) {
    constexpr std::array<const char*, 7> kPieces{"a", "b", " ", "  ", "\n", "ü", "한"};
    std::string text;
    const std::size_t count = random() % 60;
    for (std::size_t k = 0; k < count; ++k) text += kPieces[random() % kPieces.size()];
    return text;
}

}  // namespace

TEST_CASE("wrapped text: lines are broken behind spaces, and long words within") {
    const WrappedText two = wrapped("one two three", room_for(8));
    CHECK(two.shown == "one two \nthree");
    CHECK(two.breaks == std::vector<std::size_t>{8});
    CHECK(wrapped("abcdefgh", room_for(3)).shown == "abc\ndef\ngh");
    CHECK(wrapped("a\n\nb", room_for(3)).shown == "a\n\nb");
    CHECK(wrapped("", room_for(3)).shown.empty());
    CHECK(wrapped("abc   ", room_for(3)).breaks.empty());  // spaces at the end need no line
}

TEST_CASE("wrapped text: whatever the width, it is the text again, and so are its places") {
    std::mt19937 random(7);
    for (int k = 0; k < 2000; ++k) {
        const std::string text = random_text(random);
        const WrappedText box = wrapped(text, room_for(random() % 12));
        REQUIRE(text_of(box) == text);
        for (std::size_t at = 0; at <= text.size(); ++at) {
            REQUIRE(place_in_text(box, place_shown(box, at)) == at);
        }
        for (const std::size_t place : box.breaks) REQUIRE(box.shown[place] == '\n');
    }
}

TEST_CASE("wrapped text: an edit of what is shown is the same edit of the text, with its cursor") {
    std::mt19937 random(11);
    const auto inside = [](const std::string& text, std::size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    for (int k = 0; k < 4000; ++k) {
        const std::string text = random_text(random);
        const WrappedText box = wrapped(text, room_for(1 + random() % 12));
        std::size_t from = random() % (text.size() + 1);
        std::size_t to = random() % (text.size() + 1);
        while (inside(text, from)) ++from;
        while (inside(text, to)) ++to;
        if (from > to) std::swap(from, to);
        const std::string typed = random_text(random);
        if (typed.empty() && from == to) continue;
        std::string expected = text;
        expected.replace(from, to - from, typed);
        const std::size_t a = place_shown(box, from);
        const std::size_t b = place_shown(box, to);
        std::string now = box.shown;
        now.replace(a, b - a, typed);
        if (now == box.shown) continue;
        const EditedText after = edited(box, now, {a, b}, a + typed.size());
        CAPTURE(text);
        CAPTURE(box.shown);
        CAPTURE(now);
        REQUIRE(after.text == expected);
        REQUIRE(after.cursor == from + typed.size());
    }
}

TEST_CASE("wrapped text: Backspace and Delete at a break take the letter beside it") {
    Box box{wrapped("one two", room_for(4)), 4, 5};  // behind the break
    REQUIRE(box.wrapped.shown == "one \ntwo");
    box.backspace();
    CHECK(box.text() == "onetwo");
    Box other{wrapped("one two", room_for(4)), 4, 4};  // before it
    other.remove();
    CHECK(other.text() == "one wo");
    Box wide{wrapped("üü", room_for(2)), 2, 3};
    REQUIRE(wide.wrapped.shown == "ü\nü");
    wide.backspace();
    CHECK(wide.text() == "ü");
}

TEST_CASE("wrapped text: what is typed letter by letter is the text, however it is broken") {
    Box box{{}, 6};
    const std::string text = "Where two lines meet,\na third begins: größer";
    for (std::size_t k = 0; k < text.size();) {
        std::size_t end = k + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
        box.type(text.substr(k, end - k));
        k = end;
    }
    CHECK(box.text() == text);
    CHECK(place_in_text(box.wrapped, box.cursor) == text.size());
    CHECK(box.wrapped.breaks.size() > 4);
}

TEST_CASE("wrapped text: a word begins at its first letter") {
    const auto begins = [](const std::string& before, const std::string& typed) {
        const WrappedText box{before, {}};
        const std::string now = before + typed;
        return edited(box, now, {before.size(), before.size()}, now.size()).begins_word;
    };
    CHECK(begins("", "a"));
    CHECK(begins("one ", "t"));
    CHECK(begins("one\n", "t"));
    CHECK_FALSE(begins("one", "t"));
    CHECK_FALSE(begins("one", " "));
}

}  // namespace wrapped_text_test
