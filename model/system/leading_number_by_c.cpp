#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "model/system/leading_number.h"

namespace tact {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Where the digits end that begin at a place.
std::size_t behind_digits(std::string_view text, std::size_t place) {
    while (place < text.size() && is_digit(text[place])) ++place;
    return place;
}

// How much of a text is a decimal without an exponent; 0: it begins with no number.
std::size_t mantissa_length(std::string_view text) {
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    std::size_t end = behind_digits(text, first);
    std::size_t digits = end - first;
    if (end < text.size() && text[end] == '.') {
        const std::size_t behind = behind_digits(text, end + 1);
        digits += behind - end - 1;
        end = behind;
    }
    return digits == 0 ? 0 : end;
}

// With the exponent, if there is a whole one.
std::size_t number_length(std::string_view text, std::size_t mantissa) {
    if (mantissa >= text.size() || (text[mantissa] != 'e' && text[mantissa] != 'E'))
        return mantissa;
    std::size_t digits = mantissa + 1;
    if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
    const std::size_t end = behind_digits(text, digits);
    return end == digits ? mantissa : end;
}

}  // namespace

std::optional<LeadingNumber> leading_number_by_c(std::string_view text) {
    const std::size_t mantissa = mantissa_length(text);
    if (mantissa == 0) return std::nullopt;
    LeadingNumber number;
    number.length = number_length(text, mantissa);
    number.value = std::strtod(std::string(text.substr(0, number.length)).c_str(), nullptr);
    const bool is_zero =
        std::ranges::none_of(text.substr(0, mantissa), [](char c) { return c >= '1' && c <= '9'; });
    if (std::isinf(number.value) || (number.value == 0.0 && !is_zero)) return std::nullopt;
    return number;
}

}  // namespace tact
