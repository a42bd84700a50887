// Physical constants and the unit conversions of the model, each with its unit.
#pragma once

#include <numbers>

namespace tact {

// The rate every stage of the model works at; other rates are resampled on load.
inline constexpr double kModelRateHz = 10'000.0;

// Standard gravity (CGPM 1901), in the two units used here.
inline constexpr double kStandardGravityMPerS2 = 9.80665;
inline constexpr double kStandardGravityUmPerS2 = kStandardGravityMPerS2 * 1e6;

// Peak displacement of a sinusoid from its peak acceleration: a = (2 pi f)^2 v.
inline double displacement_um(double acceleration_g, double frequency_hz) {
    const double omega = 2.0 * std::numbers::pi * frequency_hz;
    return acceleration_g * kStandardGravityUmPerS2 / (omega * omega);
}

// The values that a number may have, both ends included.

struct Range {
    double low;
    double high;

    bool contains(double value) const { return value >= low && value <= high; }
    bool operator==(const Range&) const = default;
};

}  // namespace tact
