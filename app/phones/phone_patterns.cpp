#include "app/phones/phone_patterns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "devices/device/drive.h"
#include "model/io/effects_out/on_off.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSmallLossS = 0.02;  // less than that is within the pulses' own rounding

double peak_of(const Waveform& waveform) {
    double peak = 0.0;
    for (const double sample : waveform.samples_g) {
        if (std::isfinite(sample)) peak = std::max(peak, std::abs(sample));
    }
    return peak;
}

bool is_silent(const std::vector<int>& ms) {
    for (std::size_t k = 0; k < ms.size(); k += 2) {
        if (ms[k] > 0) return false;
    }
    return true;
}

std::string loss_of(const OnOff& played) {
    if (is_silent(played.ms)) return "Too weak for a phone: nothing is felt.";
    if (played.floor_lost_s < kSmallLossS) return {};
    return significant_digits(played.floor_lost_s, 2) + " s of it are too weak for a phone.";
}

}  // namespace

double phone_full_scale_g(const PatternSet& set) {
    double loudest_g = 0.0;
    for (const Vibration& vibration : set.vibrations) {
        loudest_g = std::max(loudest_g, peak_of(waveform_of(vibration)));
    }
    return loudest_g > 0.0 ? loudest_g : 1.0;
}

std::optional<std::vector<PhonePattern>> phone_patterns(const PatternSet& set,
                                                        std::stop_token stop) {
    const double full_scale_g = phone_full_scale_g(set);
    std::vector<PhonePattern> patterns;
    for (const Vibration& vibration : set.vibrations) {
        if (stop.stop_requested()) return std::nullopt;
        const Drive drive = drive_of(waveform_of(vibration), full_scale_g);
        OnOff played = on_off_of_drive(drive.samples, drive.rate_hz, 1.0);
        std::string loss = loss_of(played);
        patterns.push_back({vibration.name, std::move(played.ms), std::move(loss)});
    }
    return patterns;
}

}  // namespace tact
