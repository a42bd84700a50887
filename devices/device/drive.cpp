#include "devices/device/drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
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

}  // namespace tact
