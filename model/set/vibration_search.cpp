#include "model/set/vibration_search.h"

#include <algorithm>
#include <sstream>

#include "model/set/layers.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

std::string with_unit(double value, const char* unit) {
    return significant_digits(value, 4) + unit;
}

// The words behind "Tags:" in a note, up to the full stop.
void add_tags(const std::string& note, std::vector<std::string>& words) {
    constexpr std::string_view kMark = "Tags: ";
    const std::size_t at = note.find(kMark);
    if (at == note.npos) return;
    const std::size_t from = at + kMark.size();
    std::string tags = lower_case(note.substr(from, note.find('.', from) - from));
    std::ranges::replace(tags, ',', ' ');
    std::istringstream stream(tags);
    for (std::string word; stream >> word;) words.push_back(word);
}

void add_numbers(const Pattern& pattern, std::vector<std::string>& words) {
    words.push_back(with_unit(pattern.amplitude_g, "g"));
    for (std::size_t k = 0; k < std::min<std::size_t>(2, pattern.carriers.size()); ++k) {
        words.push_back(with_unit(pattern.carriers[k].frequency_hz, "hz"));
    }
    words.push_back(with_unit(pattern.modulation.frequency_hz, "hz"));
    words.push_back(with_unit(pattern.duration_s, "s"));
    words.push_back(pattern.rhythm.text.empty() ? "steady" : lower_case(pattern.rhythm.text));
}

}  // namespace

std::vector<std::string> words_of(const Vibration& vibration) {
    std::vector<std::string> words;
    if (vibration.locked) words.emplace_back("locked");
    if (vibration.dropped) words.emplace_back("dropped");
    add_tags(vibration.note, words);
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        words.emplace_back("layers");
        for (const Layer& layer : layered->layers) words.push_back(lower_case(layer.name));
    }
    if (!recordings_in(vibration).empty()) words.emplace_back("measured");
    for (const Pattern* pattern : patterns_in(vibration)) add_numbers(*pattern, words);
    return words;
}

VibrationSearch::VibrationSearch(const std::string& search) : text_(lower_case(search)) {
    std::istringstream stream(text_);
    for (std::string word; stream >> word;) {
        const bool is_unit = word == "g" || word == "hz" || word == "s";
        if (is_unit && !terms_.empty()) {
            terms_.back() += word;
        } else {
            terms_.push_back(word);
        }
    }
}

bool VibrationSearch::finds(const Vibration& vibration) const {
    if (lower_case(vibration.name).find(text_) != std::string::npos) return true;
    if (terms_.empty()) return false;
    const std::vector<std::string> words = words_of(vibration);
    return std::ranges::all_of(terms_, [&words](const std::string& term) {
        return std::ranges::find(words, term) != words.end();
    });
}

}  // namespace tact
