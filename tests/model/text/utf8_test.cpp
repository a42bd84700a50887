#include "model/text/utf8.h"

#include <doctest/doctest.h>

namespace utf8_test {

using namespace tact;

TEST_CASE("utf8: text in any script is valid") {
    CHECK_FALSE(first_invalid_utf8(""));
    CHECK_FALSE(first_invalid_utf8("plain"));
    CHECK_FALSE(
        first_invalid_utf8("\u00fcber \u0436\u0443\u0436 \u9707\u52a8 \U0001F91A \U0010FFFF"));
}

TEST_CASE("utf8: the first byte that does not belong is found") {
    CHECK(first_invalid_utf8("ab\xFF") == 2);
    CHECK(first_invalid_utf8("\x80") == 0);
    CHECK(first_invalid_utf8("a\xC3") == 1);             // cut off
    CHECK(first_invalid_utf8("\xC0\xAF") == 0);          // overlong /
    CHECK(first_invalid_utf8("\xE0\x80\x80") == 0);      // overlong
    CHECK(first_invalid_utf8("\xED\xA0\x80") == 0);      // half of a surrogate pair
    CHECK(first_invalid_utf8("\xF4\x90\x80\x80") == 0);  // above U+10FFFF
    CHECK(first_invalid_utf8("\xF0\x9F\xA4z") == 0);
}

TEST_CASE("utf8: broken bytes become U+FFFD and the rest stays") {
    CHECK(valid_utf8("a\xFF\xFEz\xC3") == "a\uFFFD\uFFFDz\uFFFD");
    CHECK(valid_utf8("\u9707\u52a8") == "\u9707\u52a8");
}

TEST_CASE("utf8: a byte-order mark is no text") {
    CHECK(without_bom("\xEF\xBB\xBFx") == "x");
    CHECK(without_bom("x\xEF\xBB\xBF") == "x\xEF\xBB\xBF");
    CHECK(without_bom("").empty());
}

TEST_CASE("utf8: positions count lines and characters, not bytes") {
    const std::string_view text = "one\ntwo \u9707!x";
    CHECK(position_of(text, 0).line == 1);
    CHECK(position_of(text, 0).column == 1);
    CHECK(position_of(text, text.size() - 1).line == 2);
    CHECK(position_of(text, text.size() - 1).column == 7);
    CHECK(position_of(text, 9999).line == 2);
}

TEST_CASE("utf8: long names are cut between characters") {
    CHECK(shortened("\u9707\u52a8\u9707", 2) == "\u9707\u52a8...");
    CHECK(shortened("\u9707\u52a8", 2) == "\u9707\u52a8");
    CHECK(in_quotes("a") == "\"a\"");
    CHECK(in_quotes("a\nb\t\x7F") == "\"a\\u000ab\\u0009\\u007f\"");
    CHECK(in_quotes(std::string(1000, 'a')).size() == 45);
}

TEST_CASE("utf8: a text is cut between characters, at or before the place") {
    const std::string text = "a\u00e9\u6f22\U0001f600";  // of 1, 2, 3 and 4 bytes
    std::string cuts;
    for (std::size_t bytes = 0; bytes <= 12; ++bytes) {
        const std::string_view head = whole_characters(text, bytes);
        CHECK(text.starts_with(head));
        CHECK_FALSE(first_invalid_utf8(head));
        cuts += std::to_string(head.size()) + " ";
    }
    CHECK(cuts == "0 1 1 3 3 3 6 6 6 6 10 10 10 ");
}

}  // namespace utf8_test
