#include "app/phones/phone_patterns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/device/drive.h"
#include "devices/phone/on_off_times.h"
#include "model/io/effects_out/on_off.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSmallLossS = 0.02;  // less than that is within the pulses' own rounding

std::string loss_of(const OnOff& played) {
    if (!is_ever_on(played.ms)) return "Too weak for a phone: nothing is felt.";
    if (played.floor_lost_s < kSmallLossS) return {};
    return significant_digits(played.floor_lost_s, 2) + " s of it are too weak for a phone.";
}

// Waveforms of a large set are too many to be kept for what comes next: they are rendered again.
std::optional<double> full_scale_of(const PatternSet& set, const std::stop_token& stop) {
    double loudest_g = 0.0;
    for (const Vibration& vibration : set.vibrations) {
        if (stop.stop_requested()) return std::nullopt;
        const double peak = peak_g(waveform_of(vibration));
        if (std::isfinite(peak)) loudest_g = std::max(loudest_g, peak);
    }
    return loudest_g > 0.0 ? loudest_g : 1.0;
}

}  // namespace

std::optional<PhonePatterns> phone_patterns(const PatternSet& set, std::stop_token stop) {
    const std::optional<double> full_scale_g = full_scale_of(set, stop);
    if (!full_scale_g) return std::nullopt;
    PhonePatterns made{{}, *full_scale_g};
    for (const Vibration& vibration : set.vibrations) {
        if (stop.stop_requested()) return std::nullopt;
        const Drive drive = drive_of(waveform_of(vibration), *full_scale_g);
        OnOff played = on_off_of_drive(drive.samples, drive.rate_hz, 1.0);
        std::string loss = loss_of(played);
        made.patterns.push_back({vibration.name, std::move(played.ms), std::move(loss)});
    }
    return made;
}

}  // namespace tact
