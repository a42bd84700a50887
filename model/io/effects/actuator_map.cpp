#include "model/io/effects/actuator_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "model/common/portable.h"
#include "model/io/effects/actuator_file.h"
#include "model/pattern/pattern.h"

namespace tact {

namespace {

constexpr const char* kAssumedG = " 1 g at full scale is assumed: nobody publishes it.";

ActuatorMap quest() {
    ActuatorMap map;
    map.name = "quest";
    map.source = "Hz, bursts and ducking of Meta's own configuration for Quest controllers.";
    map.frequency_hz = {55.0, 200.0};
    map.burst_at_0 = {55.0, 0.0364, BurstShape::sine};
    map.burst_at_1 = {165.0, 0.0121, BurstShape::square};
    map.ducking = 0.5;
    return map;
}

ActuatorMap console_pcm() {
    ActuatorMap map;
    map.name = "console-pcm";
    map.source = "Hz, bursts and ducking of Meta's generic configuration for console controllers.";
    map.frequency_hz = {20.0, 250.0};
    map.burst_at_0 = {55.0, 0.027, BurstShape::sine};
    map.burst_at_1 = {130.0, 0.020, BurstShape::square};
    map.ducking = 0.5;
    return map;
}

ActuatorMap console_simple() {
    ActuatorMap map;
    map.name = "console-simple";
    map.source =
        "Meta's generic configuration for motors that take an amplitude alone; its 60 Hz is a "
        "place holder.";
    map.frequency_hz = {60.0, 60.0};
    map.continuous_gain = 0.8;
    map.burst_at_0 = {60.0, 0.040, BurstShape::sine};
    map.burst_at_1 = {60.0, 0.020, BurstShape::square};
    map.ducking = 0.8;
    return map;
}

ActuatorMap core_haptics() {
    ActuatorMap map;
    map.name = "core-haptics";
    map.source =
        "Hz, gains and 22 ms of the MPEG reference software's reader of AHAP; Apple publishes "
        "none.";
    map.frequency_hz = {65.0, 300.0};
    map.continuous_gain = 0.6138;
    map.transient_gain = 0.792;
    map.burst_at_0 = {65.0, 0.022, BurstShape::sine};
    map.burst_at_1 = {300.0, 0.022, BurstShape::sine};
    return map;
}

ActuatorMap core_haptics_squared() {
    ActuatorMap map = core_haptics();
    map.name = "core-haptics-squared";
    map.source =
        "As core-haptics, but with acceleration as the square of intensity, as Meta's converter "
        "has it.";
    map.intensity_law = IntensityLaw::squared;
    return map;
}

ActuatorMap mpeg() {
    ActuatorMap map = core_haptics();
    map.name = "mpeg";
    map.source = "Hz are the file's own; 22 ms of a transient are the MPEG reference software's.";
    map.continuous_gain = map.transient_gain = 1.0;
    return map;
}

ActuatorMap interhaptics() {
    ActuatorMap map;
    map.name = "interhaptics";
    map.source = "Hz of notes are the file's own; 150 Hz of a transient are guessed.";
    map.frequency_hz = {60.0, 240.0};
    return map;
}

ActuatorMap richtap() {
    ActuatorMap map;
    map.name = "richtap";
    map.source = "Hz and lengths of transients are guessed: the vendors publish none.";
    map.frequency_hz = {50.0, 250.0};
    map.burst_at_0 = {50.0, 0.030, BurstShape::sine};
    map.burst_at_1 = {250.0, 0.012, BurstShape::sine};
    return map;
}

ActuatorMap android() {
    ActuatorMap map;
    map.name = "android";
    map.source =
        "30 to 300 Hz are those of a profile in Android's own tests; 165 Hz where a file has "
        "none, and 40 dB above threshold as the greatest level, are guessed.";
    map.frequency_hz = {30.0, 300.0};
    return map;
}

ActuatorMap phone_web() {
    ActuatorMap map;
    map.name = "phone-web";
    map.source =
        "A phone's motor that a browser switches on and off: its 165 Hz are guessed, not confirmed "
        "on a device.";
    map.frequency_hz = {165.0, 165.0};
    map.burst_at_0 = map.burst_at_1 = {165.0, 0.015, BurstShape::sine};
    return map;
}

std::array<ActuatorMap, 10> all_maps() {
    std::array<ActuatorMap, 10> maps{
        quest(), console_pcm(),  console_simple(), core_haptics(), core_haptics_squared(),
        mpeg(),  interhaptics(), richtap(),        android(),      phone_web()};
    for (ActuatorMap& map : maps) map.source += kAssumedG;
    return maps;
}

double mixed(double at_0, double at_1, double share) { return at_0 + (at_1 - at_0) * share; }

double shape_at(BurstShape shape, double turns) {
    const double phase = turns - std::floor(turns);
    switch (shape) {
        case BurstShape::saw:
            return 1.0 - 2.0 * phase;
        case BurstShape::sine:
            return portable::sin(2.0 * std::numbers::pi * phase);
        case BurstShape::square:
            return phase < 0.5 ? 1.0 : -1.0;
        case BurstShape::triangle:
            return 1.0 - std::abs(2.0 - std::abs(3.0 - 4.0 * phase));
    }
    return 0.0;
}

// Energy in g^2 s, sampled at middle points, so that steps of a square wave do no harm.
template <class Sample>
double energy_of(double duration_s, int steps, const Sample& sample) {
    double sum = 0.0;
    for (int n = 0; n < steps; ++n) {
        const double x = sample(duration_s * (n + 0.5) / steps);
        sum += x * x;
    }
    return sum * duration_s / steps;
}

// What ours has to be, in g, to have the energy of theirs: `theirs` takes a time and a number of
// turns.
template <class Theirs>
double equal_energy_g(Transient ours, double their_length_s, const Theirs& theirs) {
    // More periods would tell no more; the steps are as many as a square wave needs.
    constexpr double kEnoughPeriods = 16.0;
    constexpr double kStepsAPeriod = 32.0;
    const double hz = std::min(ours.frequency_hz, kEnoughPeriods / their_length_s);
    const double periods = std::clamp(hz * their_length_s, 2.0, kEnoughPeriods);
    const int steps = static_cast<int>(std::ceil(kStepsAPeriod * periods));
    ours.amplitude_g = 1.0;
    ours.frequency_hz = hz;
    const double own =
        energy_of(ours.duration_s, steps, [&](double t_s) { return transient_g(ours, t_s); });
    const double their =
        energy_of(their_length_s, steps, [&](double t_s) { return theirs(t_s, hz * t_s); });
    return own > 0.0 ? std::sqrt(their / own) : 0.0;
}

bool is_square_like(BurstShape shape) {
    return shape == BurstShape::square || shape == BurstShape::saw;
}

// A fading burst is a row of steady ones, of whole periods so that each begins as the last one
// ends.
int pieces_of(double fade_out, double periods) {
    constexpr double kSteady = 0.05;
    constexpr double kMostPieces = 4.0;
    if (fade_out < kSteady) return 1;
    return static_cast<int>(std::clamp(std::floor(periods), 1.0, kMostPieces));
}

Transient steady_piece(const ActuatorMap& map, double share, double hz, double duration_s) {
    const BurstShape more = share < 0.5 ? map.burst_at_0.shape : map.burst_at_1.shape;
    Transient piece;
    piece.frequency_hz = std::clamp(hz, limits::kCarrierHz.low, limits::kCarrierHz.high);
    piece.duration_s = std::clamp(duration_s, limits::kTransientS.low, limits::kTransientS.high);
    piece.shape = is_square_like(more) ? TransientShape::square : TransientShape::sine;
    return piece;
}

}  // namespace

std::span<const ActuatorMap> bundled_actuators() {
    static const std::array<ActuatorMap, 10> maps = all_maps();
    return maps;
}

std::string actuator_names() {
    std::string names;
    for (const ActuatorMap& map : bundled_actuators()) {
        names += (names.empty() ? "" : ", ") + map.name;
    }
    return names;
}

const ActuatorMap& bundled_actuator(std::string_view name) {
    const auto maps = bundled_actuators();
    const auto found = std::ranges::find(maps, name, &ActuatorMap::name);
    assert(found != maps.end() && "an actuator map of this name");
    return *found;
}

Expected<ActuatorMap> actuator_named(const std::string& name_or_file) {
    const auto maps = bundled_actuators();
    const auto found = std::ranges::find(maps, name_or_file, &ActuatorMap::name);
    if (found != maps.end()) return *found;
    std::error_code none;
    if (std::filesystem::exists(name_or_file, none)) return read_actuator_file(name_or_file);
    return Error{"--actuator: expected a file (.acf, .json) or one of " + actuator_names() +
                 ", got \"" + name_or_file + "\""};
}

double frequency_hz(const ActuatorMap& map, double frequency_01) {
    const double share = std::clamp(frequency_01, 0.0, 1.0);
    const auto [low, high] = map.frequency_hz;
    if (map.frequency_law == FrequencyLaw::linear) return mixed(low, high, share);
    return portable::exp(mixed(portable::log(low), portable::log(high), share));
}

double share_of_full_scale(const ActuatorMap& map, double intensity_01) {
    const double share = std::clamp(intensity_01, 0.0, 1.0);
    return map.intensity_law == IntensityLaw::linear ? share : share * share;
}

double continuous_g(const ActuatorMap& map, double intensity_01) {
    return map.full_scale_g * map.continuous_gain * share_of_full_scale(map, intensity_01);
}

double burst_duration_s(const ActuatorMap& map, double frequency_01) {
    return mixed(map.burst_at_0.duration_s, map.burst_at_1.duration_s,
                 std::clamp(frequency_01, 0.0, 1.0));
}

std::vector<Transient> transients_on(const ActuatorMap& map, double time_s, double intensity_01,
                                     double frequency_01, std::optional<double> cut_after_s) {
    const double share = std::clamp(frequency_01, 0.0, 1.0);
    const double whole_s = burst_duration_s(map, share);
    const double length_s = std::min(whole_s, cut_after_s.value_or(whole_s));
    const double hz = mixed(map.burst_at_0.frequency_hz, map.burst_at_1.frequency_hz, share);
    const double full_g =
        map.full_scale_g * map.transient_gain * share_of_full_scale(map, intensity_01);
    const int pieces = pieces_of(map.fade_out, length_s * hz);
    const double cycles = std::floor(length_s * hz / pieces);
    std::vector<Transient> result;
    for (int k = 0; k < pieces; ++k) {
        const double from_s = k * cycles / hz;
        const double until_s = k + 1 < pieces ? (k + 1) * cycles / hz : length_s;
        Transient piece = steady_piece(map, share, hz, until_s - from_s);
        piece.time_s = time_s + from_s;
        piece.amplitude_g =
            full_g * equal_energy_g(piece, until_s - from_s, [&](double t_s, double turns) {
                return (1.0 - map.fade_out * (from_s + t_s) / whole_s) *
                       mixed(shape_at(map.burst_at_0.shape, turns),
                             shape_at(map.burst_at_1.shape, turns), share);
            });
        result.push_back(piece);
    }
    return result;
}

Transient held_burst(double time_s, double amplitude_g, double hz, double duration_s) {
    Transient transient{time_s, amplitude_g, hz, duration_s, TransientShape::sine};
    transient.amplitude_g *= equal_energy_g(transient, duration_s, [](double, double turns) {
        return shape_at(BurstShape::sine, turns);
    });
    return transient;
}

}  // namespace tact
