// Android's timings and amplitudes as JSON, and Hapticlabs' .hla, which has the same two; on-off
// times of browsers.
//
// Source    VibrationEffect.createWaveform: ms of each step, amplitudes of 0 to 255, -1 the
//           device's own; arrays of one length and a sum above 0; without amplitudes on and off in
//           turns, off first. Hapticlabs' documentation of .hla. The W3C's Vibration API: an array
//           of ms, on first, fractions cut off; Chromium's vibration_controller.cc: its limits.
// Guessed   the Hz of all: such files have none; the device's own amplitude: the greatest.
// Left out  repetition: once; sounds. What is longer than Chrome's limits is read whole.

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/effects/effect.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kResonanceHz = 165.0;
constexpr Range kAmplitudes{-1.0, 255.0};

// As the one spells its keys, and the other.
struct TimingKeys {
    const char* timings;
    const char* amplitudes;
    const char* repeat;
};
constexpr std::array<TimingKeys, 2> kSpellings{
    {{"timings", "amplitudes", "repeat"}, {"Timings", "Amplitudes", "Repeat"}}};

std::vector<double> numbers_of(JsonObject& object, std::string_view key, Range range) {
    std::vector<double> numbers;
    for (const Json* element : array_field(object, key, 1, kMostVoicePoints)) {
        const std::string place = place_of(object, key) + "/" + std::to_string(numbers.size());
        numbers.push_back(number_at(*object.reading, *element, place, range));
        if (!object.reading->fault.empty()) break;
    }
    return numbers;
}

std::vector<double> shares_of(JsonObject& object, const TimingKeys& keys, std::size_t steps,
                              std::vector<std::string>& remarks) {
    std::vector<double> shares;
    if (object.value == nullptr || !object.value->contains(keys.amplitudes)) {
        remarks.push_back("without amplitudes: off and on in turns, off first");
        for (std::size_t k = 0; k < steps; ++k) shares.push_back(k % 2 == 0 ? 0.0 : 1.0);
        return shares;
    }
    for (const double amplitude : numbers_of(object, keys.amplitudes, kAmplitudes)) {
        if (amplitude < 0.0) remark_once(remarks, "the device's own amplitude is taken as 255");
        shares.push_back(amplitude < 0.0 ? 1.0 : amplitude / 255.0);
    }
    if (shares.size() != steps) {
        refuse_plainly(*object.reading, place_of(object, keys.amplitudes),
                       "expected as many as there are timings, " + std::to_string(steps) +
                           ", got " + std::to_string(shares.size()));
    }
    return shares;
}

// Shares of 1 would be almost silent as shares of 255.
void check_amplitudes(JsonObject& object, const TimingKeys& keys,
                      const std::vector<double>& shares) {
    if (shares.empty() || !object.reading->fault.empty()) return;
    const double largest = 255.0 * *std::ranges::max_element(shares);
    if (!(largest > 0.0) || largest > 1.0 + 1e-9) return;
    refuse_plainly(*object.reading, place_of(object, keys.amplitudes),
                   "expected amplitudes from 0 to 255, the greatest of all is " +
                       significant_digits(largest, 4) + ": these may be shares of 1");
}

bool has_elements(const Json& document, const char* key) {
    const auto found = document.find(key);
    return found != document.end() && found->is_array() && !found->empty();
}

// Steps of one share of full scale each.
Expected<Effects> effect_of(const EffectFile& file, const std::vector<double>& lengths_ms,
                            const std::vector<double>& shares, double hz,
                            std::vector<std::string> remarks) {
    double total_ms = 0.0;
    std::vector<double> ends_s;
    for (const double length_ms : lengths_ms) ends_s.push_back((total_ms += length_ms) / 1e3);
    Sketch sketch;
    sketch.unit_g = continuous_g(file.map, 1.0);
    sketch.duration_s = ends_s.back();
    const AmplitudeCurve steps = stairs(ends_s, shares);
    sketch.voices.push_back({0.0, sketch.duration_s, acceleration_curve(file.map, steps),
                             FrequencyCurve{{0.0, hz}}, 0.0});
    auto effect = finished(file, file.stem, sketch, std::move(remarks));
    if (!effect) return effect.error();
    return Effects{*std::move(effect)};
}

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

}  // namespace

Expected<Effects> read_timings(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    const TimingKeys keys = kSpellings[document.contains(kSpellings[0].timings) ? 0 : 1];
    std::vector<std::string> remarks;
    std::vector<double> lengths_ms = numbers_of(object, keys.timings, kEffectTimeMs);
    const std::vector<double> shares = shares_of(object, keys, lengths_ms.size(), remarks);
    check_amplitudes(object, keys, shares);
    const double repeat = number_field(object, keys.repeat, -1.0, {-1.0, 1e9});
    if (reading.fault.empty() &&
        !(std::accumulate(lengths_ms.begin(), lengths_ms.end(), 0.0) > 0.0)) {
        refuse_plainly(reading, place_of(object, keys.timings), "expected a sum above 0 ms");
    }
    if (!reading.fault.empty()) return Error{reading.fault};
    const double longest_ms = *std::ranges::max_element(lengths_ms);
    if (const auto times = times_make_sense(file, longest_ms); !times) return times.error();
    if (repeat >= 0.0) remarks.push_back("repeats for ever in its player; once here");
    if (has_elements(document, "Audios")) remarks.push_back("its sounds are left out");
    remark_once(remarks, "165 Hz are guessed: such files have no frequency");
    return effect_of(file, lengths_ms, shares, kResonanceHz, std::move(remarks));
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
    return effect_of(file, lengths_ms, shares, hz, std::move(remarks));
}

}  // namespace tact
