// Android's timings and amplitudes as JSON, and Hapticlabs' .hla, which has the same two.
//
// Source    VibrationEffect.createWaveform: ms of each step, amplitudes of 0 to 255, -1 the
//           device's own; arrays of one length and a sum above 0; without amplitudes on and off in
//           turns, off first. Hapticlabs' documentation of .hla.
// Guessed   the Hz of all: such files have none; the device's own amplitude: the greatest.
// Left out  repetition: once; sounds.

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/formats/android/android.h"
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

}  // namespace

Likeness android_timings_likeness(const Json& document, std::string_view) {
    return document.contains("timings") ? Likeness::likely : Likeness::none;
}

Likeness hla_likeness(const Json& document, std::string_view) {
    return document.contains("Timings") ? Likeness::likely : Likeness::none;
}

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
    return effect_of_steps(file, lengths_ms, shares, kResonanceHz, std::move(remarks));
}

}  // namespace tact
