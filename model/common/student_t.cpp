#include "model/common/student_t.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"

namespace tact {

namespace {

// P(|T| <= t), t >= 0. With theta = atan(t / sqrt(freedom)) the terms grow by
//     cos^2 2/3, 4/5, ..   of odd, from cos on;     cos^2 1/2, 3/4, ..   of even freedom, from 1
//     on.
double within(double t, std::size_t freedom) {
    const double theta = portable::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double c = portable::cos(theta);
    const bool is_odd = freedom % 2 == 1;
    double term = is_odd ? c : 1.0;
    double sum = freedom > 1 ? term : 0.0;
    for (std::size_t k = is_odd ? 3 : 2; k < freedom; k += 2) {
        term *= c * c * static_cast<double>(k - 1) / static_cast<double>(k);
        sum += term;
    }
    const double all = portable::sin(theta) * sum;
    return is_odd ? 2.0 / std::numbers::pi * (theta + all) : all;
}

}  // namespace

double two_sided_p(double t, std::size_t freedom) {
    const double size = std::abs(t);
    if (std::isnan(size)) return size;
    if (freedom == 0) return portable::erfc(size / std::numbers::sqrt2);
    return std::isinf(size) ? 0.0 : std::clamp(1.0 - within(size, freedom), 0.0, 1.0);
}

double two_sided_quantile(double coverage, std::size_t freedom) {
    assert(coverage >= 0.0 && coverage < 1.0 && "a share below 1");
    double low = 0.0;
    double high = 1.0;
    while (two_sided_p(high, freedom) > 1.0 - coverage && high < 1e12) high *= 2.0;
    constexpr int kHalvings = 80;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (low + high) / 2.0;
        (two_sided_p(middle, freedom) > 1.0 - coverage ? low : high) = middle;
    }
    return high;
}

}  // namespace tact
