// What the 0..1 of an effect file means on an actuator: Hz, g, and what a transient becomes.
//
// Most formats hold shares of what a device can do. How these meet Hz is published for a few of
// their players; how they meet g, for no player: `full_scale_g` is assumed everywhere, and
// `source`, which goes into the note of every pattern that is read, says so.
//
// Source    `source` of each; formulas in the functions below
// Left out  the response of an actuator: devices/calibration.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/common/units.h"
#include "model/pattern/curves.h"

namespace tact {

enum class FrequencyLaw { linear, logarithmic };

// Acceleration as a share of full scale, of an intensity: the field contradicts itself. MPEG's
// reference takes Core Haptics' intensity as it is, Meta's converter writes the root of its
// amplitude and so takes the square.
enum class IntensityLaw { linear, squared };

enum class BurstShape { saw, sine, square, triangle };

// A transient at one end of its 0..1 frequency.
struct Burst {
    double frequency_hz = 150.0;
    double duration_s = 0.022;
    BurstShape shape = BurstShape::sine;

    bool operator==(const Burst&) const = default;
};

struct ActuatorMap {
    std::string name;
    std::string source;  // a sentence: whose numbers, and which are guessed
    Range frequency_hz{65.0, 300.0};
    FrequencyLaw frequency_law = FrequencyLaw::linear;
    IntensityLaw intensity_law = IntensityLaw::linear;
    double full_scale_g = 1.0;
    double continuous_gain = 1.0;
    double transient_gain = 1.0;
    Burst burst_at_0;  // between the two: frequency and duration linear, shapes mixed
    Burst burst_at_1;
    double fade_out = 0.0;       // share of its amplitude that a burst has lost at its end, linear
    double ducking = 1.0;        // what the continuous part is multiplied by during a burst
    double sensation_db = 40.0;  // greatest level above threshold: Android's basic envelopes

    bool operator==(const ActuatorMap&) const = default;
};

// What the program knows by name.
std::span<const ActuatorMap> bundled_actuators();
std::string actuator_names();  // "quest, console-pcm, ..."

// Asserts that it is one of them.
const ActuatorMap& bundled_actuator(std::string_view name);

// A bundled one by its name, or a file (actuator_file.h).
Expected<ActuatorMap> actuator_named(const std::string& name_or_file);

double frequency_hz(const ActuatorMap& map, double frequency_01);
double share_of_full_scale(const ActuatorMap& map, double intensity_01);
double continuous_g(const ActuatorMap& map, double intensity_01);

// A transient as the map's device plays it, in ours: sine or square by what its shape has more of;
// as long as its burst, or where that is cut, and a row of up to four where it fades; as strong as
// makes the energy equal, as the device's burst has no flanks and mixes its shapes. 1 ms at least.
std::vector<Transient> transients_on(const ActuatorMap& map, double time_s, double intensity_01,
                                     double frequency_01, std::optional<double> cut_after_s = {});

// The same at Hz, g and a length that the file itself gives.
Transient held_burst(double time_s, double amplitude_g, double frequency_hz, double duration_s);

double burst_duration_s(const ActuatorMap& map, double frequency_01);

}  // namespace tact
