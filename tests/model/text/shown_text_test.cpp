#include "model/text/shown_text.h"

#include <doctest/doctest.h>

#include "model/text/names.h"
#include "model/text/utf8.h"

namespace shown_text_test {

using namespace tact;

TEST_CASE("shown text: what is seen stays as it is, what steers becomes its number") {
    CHECK(shown_text("") == "");
    CHECK(shown_text("Ménière 震动 🎵 שלום") == "Ménière 震动 🎵 שלום");
    CHECK(shown_text("\x1b[31mred") == "\\u001b[31mred");
    CHECK(shown_text("a\nb\tc\rd") == "a\\u000ab\\u0009c\\u000dd");
    CHECK(shown_text(std::string_view("nul\0!", 5)) == "nul\\u0000!");
    CHECK(shown_text("\u009b31m") == "\\u009b31m");
    CHECK(shown_text("\u202egnp.exe") == "\\u202egnp.exe");
    CHECK(shown_text("\x9b") == "\uFFFD");  // no UTF-8: some terminals take it for a control
}

TEST_CASE("shown text: of all characters those steer that terminals and layouts obey") {
    for (char32_t c = 0; c < 0x20; ++c) CHECK(is_steering(c));
    for (char32_t c = 0x7F; c < 0xA0; ++c) CHECK(is_steering(c));
    for (const char32_t c : {0x61C, 0x200E, 0x200F, 0x2028, 0x2029, 0x202A, 0x202E, 0x2066, 0x2069})
        CHECK(is_steering(c));
    // Neighbours: a blank, joiners of scripts and emoji, a narrow blank.
    for (const char32_t c :
         {0x20, 0x7E, 0xA0, 0x61B, 0x200C, 0x200D, 0x2010, 0x2027, 0x202F, 0x2065, 0x206A, 0x1F3B5})
        CHECK_FALSE(is_steering(c));
}

TEST_CASE("shown text: lines stay lines where a text has several") {
    CHECK(shown_lines("a\n\tb\x1b") == "a\n\tb\\u001b");
}

TEST_CASE("shown text: two names that differ are shown differently") {
    CHECK(in_quotes("a\rb") != in_quotes("a b"));
    CHECK(in_quotes("ab\u202e") != in_quotes("ab"));
}

TEST_CASE("shown text: a file's name steers nothing") {
    CHECK(file_stem("\u202egnp\u009b\n") == "-gnp--");
}

}  // namespace shown_text_test
