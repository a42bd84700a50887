// Text as it comes out of files: byte-order mark, encoding, position of a byte.
//
// Left out  normalisation, other encodings.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tact {

// The text after a UTF-8 byte-order mark, where it has one.
std::string_view without_bom(std::string_view text);

// Offset of the first byte that is not UTF-8 (overlong forms, surrogates and everything above
// U+10FFFF are not); none where all of it is.
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

// The text with every byte that is not UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

// As many whole characters from the head of a UTF-8 text as fit into `bytes`.
std::string_view whole_characters(std::string_view text, std::size_t bytes);

struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;  // in characters
};

TextPosition position_of(std::string_view text, std::size_t offset);

// At most `characters` of a text as it is shown on one line, with "..." where some are missing: for
// messages.
std::string shortened(std::string_view text, std::size_t characters = 40);

// ASCII letters in lower case: for searches.
std::string lower_case(std::string text);

void append_utf8(std::string& text, char32_t character);

// UTF-16, with a mark at its head or mostly of ASCII, as UTF-8 without the mark; nothing where the
// bytes are no UTF-16. Half a pair becomes U+FFFD.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

// A name for messages: shortened, in double quotes.
std::string in_quotes(std::string_view text);

}  // namespace tact
