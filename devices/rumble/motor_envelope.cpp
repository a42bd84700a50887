#include "devices/rumble/motor_envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "devices/rumble/two_band_tracking.h"
#include "model/signal/butterworth.h"

namespace tact {

namespace {

constexpr double kLongestOverdriveS = 0.04;  // the model of the motor may be wrong
constexpr double kFaintest = 0.02;           // envelopes below do not start a motor
constexpr double kEnvelopeWindowS = 0.04;    // Hann: half of it counts

// Samples per value of the running mean square: well above what a window of 40 ms passes.
constexpr double kEnvelopeStepS = 0.0025;

double duty_towards(const Motor& motor, double target) {
    return target > 0.0 ? motor.dead_zone + (1.0 - motor.dead_zone) * std::min(target, 1.0) : 0.0;
}

// The duty after which a motor has the wanted speed a hop later; full or none where that is still
// not enough.
double duty_to_reach(const Motor& motor, double speed, double wanted, double hop_s) {
    const double constant_s = wanted > speed ? motor.rise_s : motor.fall_s;
    const double kept = std::exp(-hop_s / constant_s);
    return duty_towards(motor, (wanted - kept * speed) / (1.0 - kept));
}

// The part of one band that is not the filters' remainder of the other; see the head of the header.
double without_leakage(double strength, double other) {
    constexpr double kLeakage = 0.25;
    const double leaked = kLeakage * other;
    return std::sqrt(std::max(0.0, strength * strength - leaked * leaked));
}

// Root of twice the weighted mean square around sample `middle`.
double strength_at(std::span<const double> signal, double rate_hz, std::ptrdiff_t middle) {
    const auto half = static_cast<std::ptrdiff_t>(std::lround(kEnvelopeWindowS / 2.0 * rate_hz));
    double weights = 0.0;
    double sum = 0.0;
    for (std::ptrdiff_t n = -half; n <= half; ++n) {
        const double turn = static_cast<double>(n) / static_cast<double>(half + 1);
        const double weight = 0.5 + 0.5 * std::cos(std::numbers::pi * turn);
        weights += weight;
        if (middle + n < 0 || middle + n >= std::ssize(signal)) continue;
        const double sample = signal[static_cast<std::size_t>(middle + n)];
        sum += weight * sample * sample;
    }
    return std::sqrt(2.0 * sum / weights);
}

}  // namespace

double speed_after(const Motor& motor, double speed, double duty, double step_s) {
    const double pull = (duty - motor.dead_zone) / (1.0 - motor.dead_zone);
    const double target = std::clamp(pull, 0.0, 1.0);
    const double constant_s = target > speed ? motor.rise_s : motor.fall_s;
    return target + (speed - target) * std::exp(-step_s / constant_s);
}

std::vector<double> envelope(std::span<const double> signal, double rate_hz, double hop_s) {
    const Drive drive{rate_hz, {signal.begin(), signal.end()}};
    const std::size_t hops = frame_count(drive, hop_s);
    std::vector<double> strengths(hops, 0.0);
    const int steps = std::max(1, static_cast<int>(std::lround(hop_s / kEnvelopeStepS)));
    for (std::size_t k = 0; k < hops; ++k) {
        for (int step = 0; step < steps; ++step) {
            const double share = (static_cast<double>(step) + 0.5) / steps;
            const double at_s = (static_cast<double>(k) + share) * hop_s;
            const auto middle = static_cast<std::ptrdiff_t>(std::lround(at_s * rate_hz));
            strengths[k] = std::max(strengths[k], strength_at(signal, rate_hz, middle));
        }
    }
    return strengths;
}

std::vector<double> below(std::span<const double> signal, double edge_hz, double rate_hz) {
    const std::vector<Section> sections = low_pass(2, edge_hz, rate_hz);
    // The filter rings on behind the end: room for what the way back still needs.
    std::vector<double> once(signal.begin(), signal.end());
    once.resize(signal.size() + static_cast<std::size_t>(std::lround(rate_hz / edge_hz * 5.0)));
    once = filtered(sections, once);
    std::ranges::reverse(once);
    std::vector<double> twice = filtered(sections, once);
    std::ranges::reverse(twice);
    twice.resize(signal.size());
    return twice;
}

std::vector<double> motor_duties(const Motor& motor, std::span<const double> envelope, double hop_s,
                                 double level) {
    std::vector<double> duties;
    double speed = 0.0;
    double overdriven_s = 0.0;
    for (const double strength : envelope) {
        const double wanted =
            strength > kFaintest ? std::sqrt(std::clamp(level * strength, 0.0, 1.0)) : 0.0;
        const double steady = duty_towards(motor, wanted);
        double duty = duty_to_reach(motor, speed, wanted, hop_s);
        overdriven_s = duty > steady ? overdriven_s + hop_s : 0.0;
        if (overdriven_s > kLongestOverdriveS + hop_s / 2.0) duty = steady;
        speed = speed_after(motor, speed, duty, hop_s);
        duties.push_back(duty);
    }
    return duties;
}

Strengths motor_pair_strengths(const Drive& drive, double hop_s) {
    const std::vector<double> below_split = below(drive.samples, kMotorSplitHz, drive.rate_hz);
    std::vector<double> above_split = drive.samples;
    for (std::size_t n = 0; n < above_split.size(); ++n) above_split[n] -= below_split[n];
    Strengths strengths{envelope(below_split, drive.rate_hz, hop_s),
                        envelope(above_split, drive.rate_hz, hop_s)};
    for (std::size_t k = 0; k < strengths.low.size(); ++k) {
        const double low = strengths.low[k];
        const double high = strengths.high[k];
        strengths.low[k] = without_leakage(low, high);
        strengths.high[k] = without_leakage(high, low);
    }
    return strengths;
}

std::vector<RumbleFrame> motor_pair_frames(const Strengths& strengths, double hop_s, double level) {
    const auto strong = motor_duties(kStrongMotor, strengths.low, hop_s, level);
    const auto weak = motor_duties(kWeakMotor, strengths.high, hop_s, level);
    std::vector<RumbleFrame> frames(strong.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        frames[k].low = strong[k];
        frames[k].high = weak[k];
    }
    return frames;
}

Strengths intensity_strengths(const Drive& drive, double hop_s) {
    constexpr double kOn = 0.05;
    constexpr double kOff = 0.03;
    Strengths strengths{envelope(drive.samples, drive.rate_hz, hop_s), {}};
    bool on = false;
    for (double& strength : strengths.low) {
        on = strength > (on ? kOff : kOn);
        if (!on) strength = 0.0;
    }
    return strengths;
}

std::vector<RumbleFrame> intensity_frames(const Strengths& strengths, double level) {
    std::vector<RumbleFrame> frames(strengths.low.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        frames[k].low = std::min(level * strengths.low[k], 1.0);
    }
    return frames;
}

std::vector<double> shaken_by(const OnOffMotor& motor, std::span<const int> ms, double rate_hz,
                              std::size_t samples) {
    std::vector<double> made(samples, 0.0);
    const double step_s = 1.0 / rate_hz;
    const double kept_on = std::exp(-step_s / motor.rise_s);
    const double kept_off = std::exp(-step_s / motor.fall_s);
    std::size_t entry = 0;
    double until_s = ms.empty() ? 0.0 : 1e-3 * ms.front();
    double strength = 0.0;
    for (std::size_t n = 0; n < samples; ++n) {
        const double at_s = (static_cast<double>(n) + 0.5) * step_s;
        while (entry < ms.size() && at_s >= until_s) {
            until_s += ++entry < ms.size() ? 1e-3 * ms[entry] : 0.0;
        }
        const bool is_on = entry < ms.size() && entry % 2 == 0;
        strength = is_on ? 1.0 + (strength - 1.0) * kept_on : strength * kept_off;
        const double turns = motor.frequency_hz * static_cast<double>(n) * step_s;
        made[n] = strength * std::sin(2.0 * std::numbers::pi * turns);
    }
    return made;
}

}  // namespace tact
