#include "model/text/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

#include "model/system/leading_number.h"

namespace tact {

namespace {

constexpr const char* kNoNumber = "\u2013";
constexpr const char* kMinus = "\u2212";

// As printf in the C locale, whatever the locale of the program.
std::string printed(double value, std::chars_format format, int digits) {
    std::array<char, 400> text{};
    const auto [end, fault] =
        std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
    return {text.data(), fault == std::errc{} ? end : text.data()};
}

void group_thousands(std::string& digits) {
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t first = digits.find_first_of("0123456789");
    if (first == std::string::npos) return;
    for (std::size_t at = point; at > first + 3;) digits.insert(at -= 3, 1, ',');
}

std::string two_places(std::int64_t number) {
    return (number < 10 ? "0" : "") + std::to_string(number);
}

// Percent of a share from 0 on, without the unit.
std::string percent_digits(double share) {
    constexpr double kRounding = 1e-9;
    constexpr double kLeastTold = 0.001;
    const double value = 100.0 * share;
    if (value < kRounding) return "0";
    if (value < kLeastTold) return "< 0.001";
    if (value < 9.95) return significant_digits(value, 2);
    if (value < 99.5 || value > 100.0 - kRounding) return fixed_digits(std::round(value), 0);
    return value < 99.95 ? fixed_digits(value, 1) : "> 99.9";
}

}  // namespace

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
    const std::optional<LeadingNumber> number = leading_number(text);
    if (!number || number->length != text.size()) return std::nullopt;
    return number->value;
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
    return printed(value, std::chars_format::general, digits);
}

std::string plain_digits(double value, int digits) {
    if (std::abs(value) < std::pow(10.0, digits)) {
        std::string text = significant_digits(value, digits);
        if (text.find("e+") == std::string::npos) return text;
    }
    return printed(value, std::chars_format::fixed, 0);
}

std::string fixed_digits(double value, int digits) {
    return std::isnan(value) ? "-" : printed(value, std::chars_format::fixed, digits);
}

double multiple_of(double step, double count) {
    // If the step is a whole share of 1, the quotient is nearest to the decimal.
    const double shares = std::round(1.0 / step);
    return step < 1.0 && shares * step == 1.0 ? count / shares : count * step;
}

std::string grouped_digits(std::uint64_t number) {
    std::string digits = std::to_string(number);
    group_thousands(digits);
    return digits;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return grouped_digits(count) + " " + (count == 1 ? one : many);
}

std::string with_true_minus(std::string digits) {
    if (digits.starts_with('-')) digits.replace(0, 1, kMinus);
    return digits;
}

std::string with_decimals(double value, int decimals) {
    if (!std::isfinite(value)) return kNoNumber;
    std::string text = fixed_digits(value, decimals);
    const bool is_zero = text.find_first_of("123456789") == std::string::npos;
    if (is_zero && text.starts_with('-')) text.erase(0, 1);
    return with_true_minus(std::move(text));
}

std::string significant(double value, int digits) {
    if (!std::isfinite(value)) return kNoNumber;
    const double size = std::abs(value);
    const int lead = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) : 0;
    return with_true_minus(fixed_digits(value, std::clamp(digits - 1 - lead, 0, 12)));
}

std::string grouped(double value, int digits) {
    std::string text = significant(value, digits);
    group_thousands(text);
    return text;
}

std::string percent(double share) {
    if (!std::isfinite(share)) return kNoNumber;
    const std::string digits = percent_digits(std::abs(share));
    if (share >= 0.0 || digits == "0") return digits + " %";
    // Below zero a bound points the other way.
    const bool is_bound = digits.front() == '<' || digits.front() == '>';
    if (!is_bound) return kMinus + digits + " %";
    return (digits.front() == '<' ? "> " : "< ") + (kMinus + digits.substr(2)) + " %";
}

std::string percent_range(double low, double high) {
    const std::string from = percent(low);
    return from.substr(0, from.find(" %")) + " to " + percent(high);
}

std::string exact_percent(double share) {
    if (!std::isfinite(share)) return kNoNumber;
    return with_true_minus(plain_digits(100.0 * share, 3)) + " %";
}

std::string percent_done(double share) {
    constexpr double kRounding = 1e-5;  // 0.7F is a little less than 0.7
    return fixed_digits(std::floor(100.0 * share + kRounding), 0) + " %";
}

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds)) return kNoNumber;
    if (seconds < 9.95) return significant_digits(seconds, 2) + " s";
    const std::int64_t whole = std::llround(seconds);
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + two_places(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + two_places(whole / 60 % 60) + " min";
}

}  // namespace tact
