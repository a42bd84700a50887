#include "devices/phone/phone_names.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <span>
#include <utility>

#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

using CharacterRange = std::pair<char32_t, char32_t>;

constexpr std::array kUnseen{CharacterRange{0xAD, 0xAD},       CharacterRange{0x34F, 0x34F},
                             CharacterRange{0x600, 0x605},     CharacterRange{0x6DD, 0x6DD},
                             CharacterRange{0x70F, 0x70F},     CharacterRange{0x115F, 0x1160},
                             CharacterRange{0x17B4, 0x17B5},   CharacterRange{0x180B, 0x180F},
                             CharacterRange{0x200B, 0x200F},   CharacterRange{0x202A, 0x202E},
                             CharacterRange{0x2060, 0x206F},   CharacterRange{0x3164, 0x3164},
                             CharacterRange{0xFE00, 0xFE0F},   CharacterRange{0xFEFF, 0xFEFF},
                             CharacterRange{0xFFA0, 0xFFA0},   CharacterRange{0xFFF0, 0xFFFF},
                             CharacterRange{0x1BCA0, 0x1BCA3}, CharacterRange{0x1D173, 0x1D17A},
                             CharacterRange{0xE0000, 0xE0FFF}};

bool is_white(char32_t character) {
    return (character >= 0x09 && character <= 0x0D) || character == 0x20 || character == 0x85 ||
           character == 0xA0 || character == 0x1680 ||
           (character >= 0x2000 && character <= 0x200A) || character == 0x2028 ||
           character == 0x2029 || character == 0x202F || character == 0x205F || character == 0x3000;
}

bool is_unseen(char32_t character) {
    return is_steering(character) || std::ranges::any_of(kUnseen, [&](const CharacterRange& range) {
               return character >= range.first && character <= range.second;
           });
}

std::size_t bytes_at_head(std::string_view valid) {
    const auto first = static_cast<unsigned char>(valid.front());
    return first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
}

// Takes one character off the head of valid UTF-8.
char32_t taken_character(std::string_view& valid) {
    const std::size_t bytes = bytes_at_head(valid);
    const auto first = static_cast<unsigned char>(valid.front());
    char32_t character = bytes == 1 ? first : first & (0xFFU >> (bytes + 1));
    for (std::size_t k = 1; k < bytes; ++k) {
        character = (character << 6U) | (static_cast<unsigned char>(valid[k]) & 0x3FU);
    }
    valid.remove_prefix(bytes);
    return character;
}

// The first characters of valid UTF-8, without a space at the end.
std::string first_characters(std::string_view valid, std::size_t count) {
    std::size_t end = 0;
    for (; count > 0 && end < valid.size(); --count) end += bytes_at_head(valid.substr(end));
    valid = valid.substr(0, end);
    while (valid.ends_with(' ')) valid.remove_suffix(1);
    return std::string(valid);
}

}  // namespace

std::string cleaned_nickname(std::string_view typed) {
    const std::string valid = valid_utf8(typed);
    std::string name;
    for (std::string_view rest = valid; !rest.empty();) {
        const char32_t character = taken_character(rest);
        if (is_white(character)) {
            if (!name.empty() && !name.ends_with(' ')) name += ' ';
        } else if (!is_unseen(character)) {
            append_utf8(name, character);
        }
    }
    name = first_characters(name, kMostNicknameCharacters);
    return name.empty() ? "Phone" : name;
}

std::string unique_nickname(const std::string& wanted, const std::set<std::string>& taken) {
    std::string name = wanted;
    for (int number = 2; taken.contains(name); ++number) {
        const std::string end = " " + std::to_string(number);
        name = first_characters(wanted, kMostNicknameCharacters - end.size()) + end;
    }
    return name;
}

namespace {

constexpr std::string_view kSecretLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

bool fill_randomly(std::span<unsigned char> bytes) {
    while (!bytes.empty()) {
        const auto count = getrandom(bytes.data(), bytes.size(), 0);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

Expected<std::string> random_secret() {
    std::array<unsigned char, 16> bytes{};
    if (!fill_randomly(bytes)) return Error{"the system gives no random numbers: try again"};
    std::string text;
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const unsigned char byte : bytes) {
        bits = (bits << 8U) | byte;
        for (count += 8; count >= 6; count -= 6) {
            text += kSecretLetters[(bits >> (count - 6)) & 63U];
        }
    }
    return text += kSecretLetters[(bits << (6 - count)) & 63U];
}

bool is_secret(std::string_view text) {
    return text.size() == kSecretLength &&
           text.find_first_not_of(kSecretLetters) == std::string_view::npos;
}

bool is_same_secret(std::string_view one, std::string_view other) {
    if (one.size() != other.size()) return false;
    unsigned difference = 0;
    for (std::size_t k = 0; k < one.size(); ++k) {
        difference |= static_cast<unsigned char>(one[k] ^ other[k]);
    }
    // Read as if it could change, so that the compiler leaves no loop early.
    volatile unsigned kept = difference;
    return kept == 0;
}

}  // namespace tact
