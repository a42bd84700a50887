// Actuator maps from files: Meta's actuator configurations (.acf, JSON5) and our own JSON.
//
//     {"actuator": "my phone", "source": "measured on ..", "frequency_hz": [80, 230],
//      "frequency_law": "linear", "intensity_law": "squared", "full_scale_g": 0.9,
//      "continuous_gain": 1, "transient_gain": 1, "fade_out": 0, "ducking": 1, "sensation_db": 40,
//      "burst_at_0": {"frequency_hz": 80, "duration_s": 0.03, "shape": "sine"}, "burst_at_1": {..}}
//
// Source    resources/acf of Meta's Haptics SDK (MIT); there emphasis_ducking multiplies the
//           continuous part: 1 leaves it as it is
// Output    errors as "FILE: PLACE: expected .."; missing keys of ours take ActuatorMap's defaults
// Left out  keys that neither knows.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace numbers {

// clang-format off
inline constexpr Number kMapFrequency{.key = "frequency_hz", .label = "Frequencies",
    .format = "%.4g Hz", .range = limits::kCarrierHz, .slider = {20.0, 500.0},
    .help = "Frequencies that 0 and 1 of a file stand for."};
inline constexpr Number kFullScale{.key = "full_scale_g", .label = "Full scale", .format = "%.3g g",
    .range = {0.001, 50.0}, .slider = {0.1, 4.0},
    .help = "Acceleration that 1 of a file stands for."};
inline constexpr Number kContinuousGain{.key = "continuous_gain", .label = "Continuous gain",
    .format = "%.3g", .range = {0.0, 1.0}, .slider = {0.0, 1.0},
    .help = "Factor of the continuous part."};
inline constexpr Number kTransientGain =
    kContinuousGain.as("transient_gain", "Transient gain", "Factor of transients.");
inline constexpr Number kFadeOut = kContinuousGain.as(
    "fade_out", "Fade out", "Share of its amplitude that a burst has lost at its end.");
inline constexpr Number kDucking =
    kContinuousGain.as("ducking", "Ducking", "Factor of the continuous part during a burst.");
inline constexpr Number kSensation{.key = "sensation_db", .label = "Sensation", .format = "%.3g dB",
    .range = {1.0, 100.0}, .slider = {1.0, 60.0}, .help = "Greatest level above threshold."};
// clang-format on

}  // namespace numbers

inline constexpr std::array<const char*, 2> kFrequencyLaws{"linear", "logarithmic"};
inline constexpr std::array<const char*, 2> kIntensityLaws{"linear", "squared"};
inline constexpr std::array<const char*, 4> kBurstShapes{"saw", "sine", "square", "triangle"};

template <class Visit>
void describe(Of<Burst>, Visit&& visit) {
    visit(numbers::kTransientFrequency, &Burst::frequency_hz);
    visit(numbers::kTransientDuration, &Burst::duration_s);
    visit("shape", OneOf{kBurstShapes}, &Burst::shape);
}

template <class Visit>
void describe(Of<ActuatorMap>, Visit&& visit) {
    visit(Text{"actuator", true}, &ActuatorMap::name);
    visit(Text{"source"}, &ActuatorMap::source);
    visit(numbers::kMapFrequency, &ActuatorMap::frequency_hz);
    visit("frequency_law", OneOf{kFrequencyLaws}, &ActuatorMap::frequency_law);
    visit("intensity_law", OneOf{kIntensityLaws}, &ActuatorMap::intensity_law);
    visit(numbers::kFullScale, &ActuatorMap::full_scale_g);
    visit(numbers::kContinuousGain, &ActuatorMap::continuous_gain);
    visit(numbers::kTransientGain, &ActuatorMap::transient_gain);
    visit("burst_at_0", &ActuatorMap::burst_at_0);
    visit("burst_at_1", &ActuatorMap::burst_at_1);
    visit(numbers::kFadeOut, &ActuatorMap::fade_out);
    visit(numbers::kDucking, &ActuatorMap::ducking);
    visit(numbers::kSensation, &ActuatorMap::sensation_db);
}

Expected<ActuatorMap> parse_actuator(std::string_view text, const std::string& file);
Expected<ActuatorMap> read_actuator_file(const std::filesystem::path& path);

// As our own JSON; reads back as the same map.
std::string print_actuator(const ActuatorMap& map);

}  // namespace tact
