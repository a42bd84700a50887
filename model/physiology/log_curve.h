// A curve over frequency with precomputed logarithms, for frequent lookups.
//
// Exact     the bits of at() of the curve itself (mechanoreceptor.h).
#pragma once

#include <vector>

#include "model/physiology/mechanoreceptor.h"

namespace tact {

struct LogCurve {
    Curve curve;
    std::vector<double> log10_hz;  // logarithms of its knots
};

struct LogFrequency {
    double frequency_hz = 1.0;
    double log10_hz = 0.0;
};

LogCurve log_curve(const Curve& curve);
LogFrequency log_frequency(double frequency_hz);

double at(const LogCurve& curve, const LogFrequency& frequency);

}  // namespace tact
