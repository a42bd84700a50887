#include "model/text/numbers.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace tact {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t begin = text.find_first_not_of(kBlank);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::optional<double> finite_number_in(std::string_view text) {
    text = trimmed(text);
    // from_chars takes no plus sign; other programs write one.
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

void append_digits(std::string& text, double value) {
    char digits[32];
    const auto [end, fault] = std::to_chars(digits, digits + sizeof(digits), value);
    text.append(digits, end);
}

std::string shortest_digits(double value) {
    std::string text;
    append_digits(text, value);
    return text;
}

std::string significant_digits(double value, int digits) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

double multiple_of(double step, double count) {
    // If the step is a whole share of 1, the quotient is nearest to the decimal.
    const double shares = std::round(1.0 / step);
    return step < 1.0 && shares * step == 1.0 ? count / shares : count * step;
}

std::string grouped_digits(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t place = digits.size(); place > 3;) digits.insert(place -= 3, 1, ',');
    return digits;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return grouped_digits(count) + " " + (count == 1 ? one : many);
}

}  // namespace tact
