#include "devices/calibration/rendering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "devices/device/playback.h"
#include "devices/rumble/motor_envelope.h"
#include "devices/rumble/rumble_plan.h"
#include "model/io/effects_out/on_off.h"
#include "model/signal/resample.h"
#include "model/signal/spectrum.h"

namespace tact {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kBuzzHz = 160.0;
constexpr Range kCoilHz{20.0, 1000.0};

// No common tone lies on an edge, where rounding it to a device's steps would move it across.
constexpr std::array kEdgesHz{0.0, 41.0, 75.0, 130.0, 225.0, 390.0, 640.0};

// Calls make(k, from, to) for the samples of every frame.
template <class Make>
void over_frames(const RumblePlan& plan, double period_s, std::size_t samples, Make make) {
    const auto sample_of = [samples, period_s](std::size_t k) {
        const double at = std::round(static_cast<double>(k) * period_s * kModelRateHz);
        return std::min(samples, static_cast<std::size_t>(at));
    };
    for (std::size_t k = 0; k < plan.size(); ++k) make(k, sample_of(k), sample_of(k + 1));
}

std::vector<double> two_sines(RumblePlan& plan, double period_s, std::size_t samples) {
    std::vector<double> made(samples, 0.0);
    double low_turns = 0.0;
    double high_turns = 0.0;
    over_frames(plan, period_s, samples, [&](std::size_t k, std::size_t from, std::size_t to) {
        const RumbleFrame told = hd_rumble_in(hd_rumble(within_one_coil(plan.rumble(k))));
        for (std::size_t n = from; n < to; ++n) {
            made[n] =
                told.low * std::sin(kTurn * low_turns) + told.high * std::sin(kTurn * high_turns);
            low_turns += told.low_hz / kModelRateHz;
            high_turns += told.high_hz / kModelRateHz;
        }
    });
    return made;
}

// A motor's shaking; `duty_of` gives frame k's duty.
template <class Duty>
std::vector<double> shaking(const Motor& motor, RumblePlan& plan, double period_s,
                            std::size_t samples, Duty duty_of) {
    std::vector<double> made(samples, 0.0);
    double speed = 0.0;
    double turns = 0.0;
    over_frames(plan, period_s, samples, [&](std::size_t k, std::size_t from, std::size_t to) {
        const double duty = std::round(255.0 * duty_of(plan.rumble(k))) / 255.0;
        for (std::size_t n = from; n < to; ++n) {
            speed = speed_after(motor, speed, duty, 1.0 / kModelRateHz);
            turns += speed * motor.full_speed_hz / kModelRateHz;
            made[n] = speed * speed * std::sin(kTurn * turns);
        }
    });
    return made;
}

std::vector<double> two_motors(RumblePlan& plan, double period_s, std::size_t samples) {
    std::vector<double> made = shaking(kStrongMotor, plan, period_s, samples,
                                       [](const RumbleFrame& frame) { return frame.low; });
    const std::vector<double> weak = shaking(kWeakMotor, plan, period_s, samples,
                                             [](const RumbleFrame& frame) { return frame.high; });
    for (std::size_t n = 0; n < samples; ++n) made[n] += weak[n];
    return made;
}

std::vector<double> buzz(RumblePlan& plan, double period_s, std::size_t samples) {
    std::vector<double> made(samples, 0.0);
    over_frames(plan, period_s, samples, [&](std::size_t k, std::size_t from, std::size_t to) {
        const double strength = plan.rumble(k).low;
        for (std::size_t n = from; n < to; ++n) {
            made[n] = strength * std::sin(kTurn * kBuzzHz * static_cast<double>(n) / kModelRateHz);
        }
    });
    return made;
}

std::vector<double> through_coil(std::vector<double> drive) {
    for (double& sample : drive) sample = std::clamp(sample, -1.0, 1.0);
    const std::vector<double> slow = below(drive, kCoilHz.low, kModelRateHz);
    std::vector<double> made = below(drive, kCoilHz.high, kModelRateHz);
    for (std::size_t n = 0; n < made.size(); ++n) made[n] -= slow[n];
    return made;
}

std::vector<double> switched(const Drive& drive, double level) {
    const OnOff on_off = on_off_of_drive(drive.samples, drive.rate_hz, level);
    return shaken_by(kGuessedPhoneMotor, on_off.ms, drive.rate_hz, drive.samples.size());
}

std::vector<double> played(RumblePlan& plan, const ActuatorTraits& about, std::size_t samples) {
    switch (about.language) {
        case Language::two_bands:
            return two_sines(plan, about.period_s, samples);
        case Language::motor_pair:
            return two_motors(plan, about.period_s, samples);
        case Language::intensity:
        case Language::waveform:
        case Language::on_off:
            break;
    }
    return buzz(plan, about.period_s, samples);
}

std::vector<double> band_energies(const Waveform& waveform) {
    std::vector<double> energies(kEdgesHz.size(), 0.0);
    const Spectrum spectrum = amplitude_spectrum(waveform.samples_g, waveform.rate_hz);
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        const auto edge = std::ranges::upper_bound(kEdgesHz, frequency_hz(spectrum, k));
        const bool unpaired = k == 0 || 2 * k == spectrum.samples;
        energies[static_cast<std::size_t>(edge - kEdgesHz.begin()) - 1] +=
            (unpaired ? 1.0 : 0.5) * spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
    }
    return energies;
}

// Phases are the actuator's own, so waveforms cannot be told apart sample by sample: what counts is
// how much there is in each band.
void compare_bands(const Waveform& intended, Rendering& rendering) {
    const std::vector<double> meant = band_energies(intended);
    const std::vector<double> made = band_energies(rendering.waveform);
    double whole = 0.0;
    double lost = 0.0;
    double added = 0.0;
    for (std::size_t k = 0; k < kEdgesHz.size(); ++k) {
        const double high_hz = k + 1 < kEdgesHz.size() ? kEdgesHz[k + 1] : kModelRateHz / 2.0;
        const double less = std::max(0.0, meant[k] - made[k]);
        const double share = meant[k] > 0.0 ? less / meant[k] : 0.0;
        rendering.bands.push_back({kEdgesHz[k], high_hz, meant[k], made[k], share});
        whole += meant[k];
        lost += less;
        added += std::max(0.0, made[k] - meant[k]);
    }
    if (!(whole > 0.0)) return;
    rendering.share_lost = lost / whole;
    rendering.share_added = added / whole;
}

// The limiter turns down all of what is too strong, as devices/device/playback.h does.
void render_calibrated(const Waveform& meant, Rendering& rendering) {
    const Calibration& calibration = *rendering.by.calibration;
    CalibratedDrive driven = calibrated_drive(meant, calibration);
    // The level that is asked for, or the strongest that the actuator bears.
    const double level = rendering.by.level;
    double share = std::min(level, driven.drive.largest_level);
    if (share * driven.peak > kCeiling) share = kCeiling / driven.peak;
    for (double& sample : driven.drive.samples) sample *= share;
    rendering.clipped = share < level;
    rendering.warnings = std::move(driven.warnings);
    rendering.waveform.samples_g = acceleration_g(driven.drive, calibration);
}

void render_uncalibrated(const Waveform& meant, Rendering& rendering) {
    const RenderedBy& by = rendering.by;
    const std::size_t samples = meant.samples_g.size();
    Drive drive = drive_of(meant, by.full_scale_g);
    rendering.clipped = by.level * peak_g(meant) > by.full_scale_g;
    const ActuatorTraits& about = traits(by.kind);
    if (about.language == Language::waveform) {
        for (double& sample : drive.samples) sample *= by.level;
        rendering.waveform.samples_g = through_coil(std::move(drive.samples));
    } else if (about.language == Language::on_off) {
        rendering.waveform.samples_g = switched(drive, by.level);
    } else {
        RumblePlan plan(std::move(drive), about.language, about.period_s, by.level);
        rendering.waveform.samples_g = played(plan, about, samples);
        for (std::size_t k = 0; about.language == Language::two_bands && k < plan.size(); ++k) {
            const TrackedFrame& frame = plan.tracked(k);
            rendering.frames.push_back({static_cast<double>(k) * about.period_s, frame.share_lost,
                                        frame.folded, frame.noise});
        }
    }
    for (double& sample : rendering.waveform.samples_g) sample *= by.full_scale_g;
}

}  // namespace

bool is_calibrated(const RenderedBy& by) {
    return by.calibration && traits(by.kind).language == Language::waveform;
}

Rendering rendering(const RenderedBy& by, const Waveform& intended) {
    Waveform meant =
        intended.rate_hz == kModelRateHz ? intended : resampled(intended, kModelRateHz);
    Rendering rendering;
    rendering.by = by;
    rendering.waveform.rate_hz = kModelRateHz;
    if (is_calibrated(by)) {
        render_calibrated(meant, rendering);
    } else {
        render_uncalibrated(meant, rendering);
    }
    for (double& sample : meant.samples_g) sample *= by.level;
    compare_bands(meant, rendering);
    return rendering;
}

}  // namespace tact
