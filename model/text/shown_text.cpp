#include "model/text/shown_text.h"

#include <algorithm>
#include <cstdio>

#include "model/text/utf8.h"

namespace tact {

namespace {

// The character at the head of a UTF-8 text that has one, and its bytes.
struct Head {
    char32_t character = 0;
    std::size_t bytes = 1;
};

Head head_of(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    char32_t character = first & (0xFFU >> (bytes + 1));
    for (std::size_t k = 1; k < bytes; ++k) {
        character = (character << 6U) | (static_cast<unsigned char>(text[k]) & 0x3FU);
    }
    return {character, bytes};
}

template <class Instead>
std::string replaced(std::string_view text, const Instead& instead) {
    const std::string valid = valid_utf8(text);
    std::string shown;
    shown.reserve(valid.size());
    for (std::string_view rest = valid; !rest.empty();) {
        const Head head = head_of(rest);
        if (is_steering(head.character)) {
            shown += instead(head.character);
        } else {
            shown += rest.substr(0, head.bytes);
        }
        rest.remove_prefix(head.bytes);
    }
    return shown;
}

}  // namespace

bool is_steering(char32_t character) {
    const auto within = [character](char32_t first, char32_t last) {
        return character >= first && character <= last;
    };
    return character < 0x20 || within(0x7F, 0x9F) || character == 0x061C ||
           within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069);
}

bool has_steering(std::string_view text) {
    // Those in two and three bytes begin with C2, D8 and E2.
    const auto may_be = [](char sign) {
        const auto byte = static_cast<unsigned char>(sign);
        return byte < 0x20 || byte == 0x7F || byte == 0xC2 || byte == 0xD8 || byte == 0xE2;
    };
    return std::ranges::any_of(text, may_be) && shown_text(text) != text;
}

std::string number_of_character(char32_t character) {
    char text[16];
    std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(character));
    return text;
}

std::string shown_text(std::string_view text) { return replaced(text, number_of_character); }

std::vector<std::string> shown_texts(std::vector<std::string> texts) {
    for (std::string& text : texts) text = shown_text(text);
    return texts;
}

std::string shown_lines(std::string_view text) {
    return replaced(text, [](char32_t character) {
        const bool is_layout = character == '\n' || character == '\t';
        return is_layout ? std::string(1, static_cast<char>(character))
                         : number_of_character(character);
    });
}

std::string without_steering(std::string_view text, char instead) {
    return replaced(text, [instead](char32_t) { return std::string(1, instead); });
}

}  // namespace tact
