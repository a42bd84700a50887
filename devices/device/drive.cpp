#include "devices/device/drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace tact {

Drive drive_of(const Waveform& waveform, double full_scale_g) {
    assert(full_scale_g > 0.0 && "a full scale of no strength");
    Drive drive{waveform.rate_hz, waveform.samples_g};
    for (double& sample : drive.samples) sample /= full_scale_g;
    return drive;
}

Drive test_buzz() {
    constexpr double kFrequencyHz = 150.0;
    constexpr double kDurationS = 0.3;
    constexpr double kRiseS = 0.01;
    Drive drive;
    const std::size_t count = sample_count(kDurationS, drive.rate_hz);
    for (std::size_t n = 0; n < count; ++n) {
        const double t_s = static_cast<double>(n) / drive.rate_hz;
        const double rise = std::min({1.0, t_s / kRiseS, (kDurationS - t_s) / kRiseS});
        drive.samples.push_back(rise * std::sin(2.0 * std::numbers::pi * kFrequencyHz * t_s));
    }
    return drive;
}

double kept_level(double level, double largest_level) {
    const double asked = level > 0.0 ? std::min(level, 1.0) : 0.0;
    return asked > largest_level ? std::max(0.0, largest_level) : asked;
}

double kept_s(double duration_s, bool loop, double longest_s) {
    const double whole_s = loop ? std::numeric_limits<double>::infinity() : duration_s;
    return longest_s < whole_s ? std::max(0.0, longest_s) : whole_s;
}

}  // namespace tact
