#include "model/text/names.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <unordered_map>

#include "model/common/fingerprint.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// "-1a2b3c4d"
std::string number_of_whole(std::string_view name) {
    const std::uint64_t number = mixed(0, std::span<const char>(name));
    char text[16];
    std::snprintf(text, sizeof text, "-%08x", static_cast<unsigned>(number >> 32U));
    return text;
}

}  // namespace

std::string file_stem(std::string_view name) {
    constexpr std::string_view kRefused = "/\\:*?\"<>|";
    std::string stem = without_steering(name, '-');
    for (char& c : stem) {
        if (kRefused.find(c) != kRefused.npos) c = '-';
    }
    if (stem.empty() || stem.front() == '.') stem.insert(stem.begin(), '-');
    if (stem.size() <= kLongestStem) return stem;
    const std::string end = number_of_whole(name);
    return std::string(whole_characters(stem, kLongestStem - end.size())) + end;
}

std::optional<std::pair<std::size_t, std::size_t>> first_equal(
    const std::vector<std::string>& names) {
    std::unordered_map<std::string_view, std::size_t> places;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto [place, is_new] = places.emplace(names[k], k);
        if (!is_new) return std::pair{place->second, k};
    }
    return std::nullopt;
}

std::string name_fault(const std::string& name) {
    if (name.size() <= kMaxNameBytes) return {};
    return "expected a name of at most " + grouped_digits(kMaxNameBytes) + " bytes, got " +
           grouped_digits(name.size());
}

std::string UnusedNames::unused(const std::string& wanted) {
    std::string name = wanted;
    while (!taken.insert(name).second) {
        int& number = last_number.try_emplace(wanted, 1).first->second;
        const std::string end = " " + std::to_string(++number);
        name = std::string(whole_characters(wanted, kMaxNameBytes - end.size())) + end;
    }
    return name;
}

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Takes the number off the head of a text; its digits without leading zeros.
std::string_view take_number(std::string_view& text) {
    const auto end = std::ranges::find_if_not(text, is_digit);
    std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
}

}  // namespace

bool naturally_before(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a;
    const std::string_view whole_b = b;
    while (!a.empty() && !b.empty()) {
        if (is_digit(a.front()) && is_digit(b.front())) {
            const std::string_view number_a = take_number(a);
            const std::string_view number_b = take_number(b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
        } else {
            // string_view compares as unsigned bytes, and UTF-8 keeps the order of code points.
            const int order = a.substr(0, 1).compare(b.substr(0, 1));
            if (order != 0) return order < 0;
            a.remove_prefix(1);
            b.remove_prefix(1);
        }
    }
    if (a.empty() != b.empty()) return a.empty();
    return whole_a < whole_b;
}

}  // namespace tact
