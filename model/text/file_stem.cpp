#include "model/text/file_stem.h"

#include <cstdio>

#include "model/common/fingerprint.h"
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

}  // namespace tact
