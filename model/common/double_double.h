// Numbers of twice the digits: the unrounded sum of two doubles.
//
// Every step is one IEEE operation on doubles, so results are the same bits everywhere; without
// FMA, which not every processor has.
//
// Source    Dekker 1971, A floating-point technique for extending the available precision;
//           Joldes, Muller & Popescu 2017 (error bounds: a few parts in 2^104)
// Valid     finite numbers below 1e290, whose products do not underflow
#pragma once

namespace tact {

struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;  // at most half a unit in the last place of `high`
};

// Valid for |a| >= |b|, or a = 0.
constexpr DoubleDouble quick_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

constexpr DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}

// The upper half of the digits: products of halves are exact.
constexpr double upper_half(double a) {
    const double scaled = 134217729.0 * a;  // 2^27 + 1
    return scaled - (scaled - a);
}

constexpr DoubleDouble exact_product(double a, double b) {
    const double product = a * b;
    const double a_high = upper_half(a);
    const double a_low = a - a_high;
    const double b_high = upper_half(b);
    const double b_low = b - b_high;
    return {product,
            ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble sum = quick_sum(high.high, high.low + low.high);
    return quick_sum(sum.high, sum.low + low.low);
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return quick_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - DoubleDouble{first, 0.0} * b;
    const double second = rest.high / b.high;
    const DoubleDouble more = rest - DoubleDouble{second, 0.0} * b;
    return quick_sum(first, second) + DoubleDouble{more.high / b.high, 0.0};
}

}  // namespace tact
