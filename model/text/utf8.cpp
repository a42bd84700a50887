#include "model/text/utf8.h"

#include <algorithm>
#include <array>

#include "model/text/shown_text.h"

namespace tact {

namespace {

constexpr bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

// Length of the character at the head of a text, 0 where it is not UTF-8.
std::size_t character_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length),
                     continues)) {
        return 0;
    }
    const auto second = static_cast<unsigned char>(text[1]);
    const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool surrogate = first == 0xED && second >= 0xA0;
    const bool too_high = first == 0xF4 && second >= 0x90;
    return overlong || surrogate || too_high ? 0 : length;
}

}  // namespace

std::string_view without_bom(std::string_view text) {
    constexpr std::string_view kBom = "\xEF\xBB\xBF";
    if (text.starts_with(kBom)) text.remove_prefix(kBom.size());
    return text;
}

std::optional<std::size_t> first_invalid_utf8(std::string_view text) {
    for (std::size_t offset = 0; offset < text.size();) {
        const std::size_t length = character_length(text.substr(offset));
        if (length == 0) return offset;
        offset += length;
    }
    return std::nullopt;
}

std::string valid_utf8(std::string_view text) {
    std::string result;
    while (const auto invalid = first_invalid_utf8(text)) {
        result.append(text.substr(0, *invalid)).append("\xEF\xBF\xBD");
        text.remove_prefix(*invalid + 1);
    }
    return result.append(text);
}

std::string_view whole_characters(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && continues(text[bytes])) --bytes;
    return text.substr(0, bytes);
}

TextPosition position_of(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t newline = before.rfind('\n');
    const std::string_view line = newline == before.npos ? before : before.substr(newline + 1);
    const auto characters = std::ranges::count_if(line, [](char byte) { return !continues(byte); });
    return {1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
            1 + static_cast<std::size_t>(characters)};
}

std::string shortened(std::string_view text, std::size_t characters) {
    std::size_t end = 0;
    for (; end < text.size(); ++end) {
        if (!continues(text[end]) && characters-- == 0) break;
    }
    return shown_text(text.substr(0, end)) + (end < text.size() ? "..." : "");
}

std::string lower_case(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

std::string in_quotes(std::string_view text) { return '"' + shortened(text) + '"'; }

namespace {

std::string from_utf16(std::string_view bytes, bool is_big_endian) {
    const auto unit = [&](std::size_t k) {
        const auto low = static_cast<unsigned char>(bytes[k + (is_big_endian ? 1 : 0)]);
        const auto high = static_cast<unsigned char>(bytes[k + (is_big_endian ? 0 : 1)]);
        return static_cast<char32_t>(high << 8U | low);
    };
    std::string text;
    text.reserve(bytes.size());
    for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) {
        char32_t character = unit(k);
        const bool is_first_half = character >= 0xD800 && character < 0xDC00;
        if (is_first_half && k + 3 < bytes.size() && (unit(k + 2) & 0xFC00U) == 0xDC00U) {
            character = 0x10000 + ((character - 0xD800) << 10U) + (unit(k + 2) - 0xDC00);
            k += 2;
        } else if (character >= 0xD800 && character < 0xE000) {
            character = 0xFFFD;
        }
        append_utf8(text, character);
    }
    return text;
}

// Which half of a pair of bytes is 0 in ASCII; none where the bytes are no UTF-16.
enum class Halves { none, low, high };

Halves halves_of(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE")) return Halves::low;
    if (bytes.starts_with("\xFE\xFF")) return Halves::high;
    const std::size_t pairs = std::min<std::size_t>(bytes.size() / 2, 512);
    std::array<std::size_t, 2> zeros{};
    for (std::size_t k = 0; k < 2 * pairs; ++k) zeros[k % 2] += bytes[k] == '\0' ? 1 : 0;
    if (pairs < 2) return Halves::none;
    if (zeros[0] == 0 && 2 * zeros[1] > pairs) return Halves::low;
    if (zeros[1] == 0 && 2 * zeros[0] > pairs) return Halves::high;
    return Halves::none;
}

}  // namespace

void append_utf8(std::string& text, char32_t character) {
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (character < 0x80) return put(character);
    if (character < 0x800) {
        put(0xC0 | (character >> 6U));
    } else {
        if (character < 0x10000) {
            put(0xE0 | (character >> 12U));
        } else {
            put(0xF0 | (character >> 18U));
            put(0x80 | ((character >> 12U) & 0x3FU));
        }
        put(0x80 | ((character >> 6U) & 0x3FU));
    }
    put(0x80 | (character & 0x3FU));
}

std::optional<std::string> utf8_of_utf16(std::string_view bytes) {
    const Halves halves = halves_of(bytes);
    if (halves == Halves::none) return std::nullopt;
    std::string text = from_utf16(bytes, halves == Halves::high);
    if (without_bom(text).size() != text.size()) text.erase(0, 3);
    return text;
}

}  // namespace tact
