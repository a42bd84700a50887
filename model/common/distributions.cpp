#include "model/common/distributions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
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

namespace {

constexpr double kLogSqrtTwoPi = 0.91893853320467274178;

double log_gamma(double z) {
    // Gamma(z) = Gamma(z + n) / (z (z + 1) .. (z + n - 1)): the series is for large z.
    double product = 1.0;
    for (; z < 15.0; z += 1.0) product *= z;
    const double w = 1.0 / (z * z);
    const double series =
        (1.0 / 12 - w * (1.0 / 360 - w * (1.0 / 1260 - w * (1.0 / 1680 - w / 1188)))) / z;
    return (z - 0.5) * portable::log(z) - z + kLogSqrtTwoPi + series - portable::log(product);
}

// The continued fraction of I_x(a, b), for x below the mean, where it converges at once.
double beta_fraction(double x, double a, double b) {
    constexpr double kTiny = 1e-300;
    constexpr int kMostSteps = 100'000;
    double c = 1.0;
    double d = 1.0 - (a + b) * x / (a + 1.0);
    d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
    double value = d;
    for (int m = 1; m < kMostSteps; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        double change = 1.0;
        for (const double step : {even, odd}) {
            d = 1.0 + step * d;
            c = 1.0 + step / c;
            d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
            if (std::abs(c) < kTiny) c = kTiny;
            change = c * d;
            value *= change;
        }
        if (std::abs(change - 1.0) < 1e-15) break;
    }
    return value;
}

// The regularised incomplete beta; `y` is 1 - x, with its own digits.
double beta_share(double x, double y, double a, double b) {
    if (x <= 0.0) return 0.0;
    if (y <= 0.0) return 1.0;
    if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - beta_share(y, x, b, a);
    const double log_front = log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * portable::log(x) +
                             b * portable::log(y);
    return portable::exp(log_front) * beta_fraction(x, a, b) / a;
}

}  // namespace

double f_share_below(double value, double df1, double df2) {
    if (!(value > 0.0)) return 0.0;
    const double whole = df1 * value + df2;
    return beta_share(df1 * value / whole, df2 / whole, 0.5 * df1, 0.5 * df2);
}

double f_quantile(double share, double df1, double df2) {
    double low = 0.0;
    double high = 1.0;
    while (f_share_below(high, df1, df2) < share && high < 1e300) {
        low = high;
        high *= 2.0;
    }
    // Halves until no double lies between.
    for (int step = 0; step < 2000; ++step) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        (f_share_below(middle, df1, df2) < share ? low : high) = middle;
    }
    return high;
}

double quantile(std::span<const double> sorted, double share) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    // 0.29 of 100 is less than 29 in binary, and would miss the value itself.
    if (std::abs(place - std::round(place)) <= kShareSpare) place = std::round(place);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace tact
