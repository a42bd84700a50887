#include "devices/rumble/on_off_motor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tact {

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
