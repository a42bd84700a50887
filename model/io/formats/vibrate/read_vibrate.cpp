// On-off times of browsers, a JSON array.
//
// Source    the W3C's Vibration API: an array of ms, on first, fractions cut off; Chromium's
//           vibration_controller.cc: its limits
// Guessed   the Hz of all: such files have none. What is longer than Chrome's limits is read whole.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/io/formats/vibrate/vibrate.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

void cut_fractions(std::vector<double>& lengths_ms, std::vector<std::string>& remarks) {
    for (double& length_ms : lengths_ms) {
        const double whole_ms = std::floor(length_ms);
        if (whole_ms != length_ms) remark_once(remarks, "fractions of a ms are cut off");
        length_ms = whole_ms;
    }
}

// Another program may play it in pieces, as ours does.
void remark_on_limits(const std::vector<double>& lengths_ms, std::vector<std::string>& remarks) {
    constexpr std::size_t kMostEntries = 99;
    constexpr double kLongestMs = 10'000.0;
    if (lengths_ms.size() > kMostEntries) {
        remarks.push_back("Chrome plays the first 99 of its " + grouped_digits(lengths_ms.size()) +
                          " times in one call");
    }
    if (std::ranges::max(lengths_ms) > kLongestMs) {
        remarks.push_back("Chrome cuts times of more than 10,000 ms");
    }
}

// Numbers and nothing else: arrays of other things are other programs'.
bool is_of_numbers(const Json& document) {
    if (!document.is_array() || document.empty()) return false;
    return std::ranges::all_of(document, [](const Json& element) { return element.is_number(); });
}

}  // namespace

Likeness vibrate_likeness(const Json& document, std::string_view path) {
    const bool is_array_named_so =
        document.is_array() && lower_case(std::string(path)).ends_with(kVibrateEnding);
    return is_of_numbers(document) || is_array_named_so ? Likeness::certain : Likeness::none;
}

Expected<Effects> read_vibrate(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    std::vector<std::string> remarks;
    if (document.size() > kMostVoicePoints) {
        return Error{file.path + ": expected at most " + grouped_digits(kMostVoicePoints) +
                     " times, got " + grouped_digits(document.size())};
    }
    std::vector<double> lengths_ms;
    std::vector<double> shares;
    for (const Json& element : document) {
        const std::string place = "/" + std::to_string(lengths_ms.size());
        lengths_ms.push_back(number_at(reading, element, place, kEffectTimeMs));
        shares.push_back(shares.size() % 2 == 0 ? 1.0 : 0.0);
        if (!reading.fault.empty()) return Error{reading.fault};
    }
    const double longest_ms = lengths_ms.empty() ? 0.0 : std::ranges::max(lengths_ms);
    if (const auto times = times_make_sense(file, longest_ms); !times) return times.error();
    if (!(longest_ms > 0.0)) return Error{file.path + ": expected a sum above 0 ms"};
    cut_fractions(lengths_ms, remarks);
    remark_on_limits(lengths_ms, remarks);
    const double hz = frequency_hz(file.map, 0.5);
    remark_once(remarks,
                significant_digits(hz, 4) + " Hz are guessed: such files have no frequency");
    return effect_of_steps(file, lengths_ms, shares, hz, std::move(remarks));
}

}  // namespace tact
