#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/common/double_double.h"
#include "model/common/portable.h"

namespace tact::portable {

namespace {

constexpr DoubleDouble kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr DoubleDouble kOverLn2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr DoubleDouble kOverLn10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

constexpr DoubleDouble whole(double value) { return {value, 0.0}; }

// 2^(j / 64).
constexpr std::size_t kPowers = 64;
constexpr auto kPower = [] {
    std::array<DoubleDouble, kPowers> powers{};
    for (std::size_t j = 0; j < kPowers; ++j) {
        const DoubleDouble x = kLn2 * whole(static_cast<double>(j) / kPowers);
        DoubleDouble sum = whole(1.0);
        for (double n = 30.0; n > 0.0; n -= 1.0) sum = whole(1.0) + x * sum / whole(n);
        powers[j] = sum;
    }
    return powers;
}();

// c = about 64 / j, and ln c = 2 atanh((c - 1) / (c + 1)).
struct Divisor {
    double c = 1.0;
    DoubleDouble log;
};
constexpr std::size_t kFirstDivisor = 45;  // sqrt(1/2) in 64ths
constexpr std::size_t kLastDivisor = 91;
constexpr auto kDivisor = [] {
    std::array<Divisor, kLastDivisor - kFirstDivisor + 1> divisors{};
    for (std::size_t k = 0; k < divisors.size(); ++k) {
        const double c = 64.0 / static_cast<double>(kFirstDivisor + k);
        const DoubleDouble z = exact_sum(c, -1.0) / exact_sum(c, 1.0);
        DoubleDouble sum{};
        for (double n = 45.0; n > 0.0; n -= 2.0) sum = whole(1.0) / whole(n) + z * z * sum;
        divisors[k] = {c, whole(2.0) * z * sum};
    }
    return divisors;
}();

// 2^exponent times a number near 1; past the ends of what a double holds, too.
double scaled(DoubleDouble value, std::int64_t exponent) {
    if (exponent > -1000 && exponent < 1000) {
        return value.high *
               std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
    }
    return std::ldexp(value.high, static_cast<int>(exponent));
}

// e^x as 2^(k / 64) e^rest.
double exp_of(DoubleDouble x) {
    if (std::isnan(x.high)) return kNoNumber;
    if (x.high > 710.0) return kInfinite;
    if (x.high < -746.0) return 0.0;
    constexpr double kStepsA1 = 0x1.71547652b82fep+6;  // 64 / ln 2
    constexpr double kRounding = 0x1.8p52;
    const double k = (x.high * kStepsA1 + kRounding) - kRounding;
    // ln 2 / 64 in pieces: k times the first two is exact.
    const DoubleDouble first = exact_sum(x.high - k * 0x1.62e42feep-7, -k * 0x1.a39ef356p-39);
    const DoubleDouble rest = quick_sum(first.high, first.low + x.low - k * 0x1.93c7673007e5fp-71);
    const double r = rest.high;
    const double beyond_r =
        r * r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0))))) +
        rest.low + r * rest.low;
    const auto step = static_cast<std::int64_t>(k);
    const DoubleDouble& power = kPower[static_cast<std::size_t>(step) % kPowers];
    const DoubleDouble more = exact_product(power.high, r);
    const DoubleDouble sum = quick_sum(power.high, more.high);
    const double low = sum.low + (more.low + power.high * beyond_r + power.low + power.low * r);
    return scaled(quick_sum(sum.high, low), (step - (step & 63)) / 64);
}

// A finite number above 0 as 2^exponent times a fraction of sqrt(1/2) to sqrt(2).
struct Parts {
    double exponent = 0.0;
    DoubleDouble log_fraction;
};

Parts parts_of(double value) {
    Parts parts;
    if (value < std::numeric_limits<double>::min()) {
        value *= 0x1p54;
        parts.exponent = -54.0;
    }
    auto bits = std::bit_cast<std::uint64_t>(value);
    parts.exponent += static_cast<double>(static_cast<std::int64_t>(bits >> 52U) - 1023);
    double fraction =
        std::bit_cast<double>((bits & 0x000f'ffff'ffff'ffffU) | 0x3ff0'0000'0000'0000U);
    if (fraction > 0x1.6a09e667f3bcdp+0) {
        fraction /= 2.0;
        parts.exponent += 1.0;
    }
    const auto place = static_cast<std::size_t>(fraction * 64.0 + 0.5) - kFirstDivisor;
    const Divisor& divisor = kDivisor[place];
    // ln(1 + r) = r - r^2/2 + r^3/3 - ..., |r| < 0.012.
    const DoubleDouble product = exact_product(fraction, divisor.c);
    const DoubleDouble rest = quick_sum(product.high - 1.0, product.low);
    const double r = rest.high;
    const double beyond_square =
        r * r * r *
        (1.0 / 3.0 -
         r * (1.0 / 4.0 -
              r * (1.0 / 5.0 -
                   r * (1.0 / 6.0 -
                        r * (1.0 / 7.0 - r * (1.0 / 8.0 - r * (1.0 / 9.0 - r * (1.0 / 10.0))))))));
    const DoubleDouble square = exact_product(r, r);
    const DoubleDouble to_square = rest - DoubleDouble{square.high / 2.0, square.low / 2.0};
    parts.log_fraction = to_square + whole(beyond_square - r * rest.low) - divisor.log;
    return parts;
}

DoubleDouble log_of(double value) {
    const Parts parts = parts_of(value);
    return whole(parts.exponent) * kLn2 + parts.log_fraction;
}

bool has_log(double value) { return value > 0.0 && value < kInfinite; }

// Logarithms that are not finite: of 0, infinity, negative numbers and NaN.
double odd_log(double value) {
    if (value == 0.0) return -kInfinite;
    return value > 0.0 ? kInfinite : kNoNumber;
}

bool is_whole(double value) { return std::floor(value) == value; }
bool is_odd(double value) { return is_whole(value) && !is_whole(value / 2.0); }

}  // namespace

double exp(double value) { return exp_of(whole(value)); }

double log(double value) { return has_log(value) ? log_of(value).high : odd_log(value); }

double log2(double value) {
    if (!has_log(value)) return odd_log(value);
    const Parts parts = parts_of(value);
    return (whole(parts.exponent) + parts.log_fraction * kOverLn2).high;
}

double log10(double value) {
    return has_log(value) ? (log_of(value) * kOverLn10).high : odd_log(value);
}

double pow(double base, double exponent) {
    if (exponent == 0.0 || base == 1.0) return 1.0;
    if (std::isnan(base) || std::isnan(exponent)) return kNoNumber;
    const double size = std::abs(base);
    const bool is_negative = std::signbit(base) && is_odd(exponent);
    if (base < 0.0 && !is_whole(exponent) && std::isfinite(base)) return kNoNumber;
    double result = 1.0;
    if (size == 0.0 || std::isinf(size)) {
        result = (size == 0.0) == (exponent < 0.0) ? kInfinite : 0.0;
    } else if (std::isinf(exponent) || size == 1.0) {
        if (size != 1.0) result = (size > 1.0) == (exponent > 0.0) ? kInfinite : 0.0;
    } else {
        const DoubleDouble log = log_of(size);
        // Beyond the ends of exp the product itself may overflow.
        const double about = log.high * exponent;
        result = std::abs(about) < 1000.0 ? exp_of(log * whole(exponent)) : exp_of(whole(about));
    }
    return is_negative ? -result : result;
}

// Near 0 from the series of erf, erf x = 2 / sqrt(pi) e^(-x^2) sum 2^n x^(2n+1) / (2n+1)!!, whose
// terms have one sign; farther out from the continued fraction of erfc.
double erfc(double value) {
    constexpr double kOverRootPi = 0x1.20dd750429b6dp-1;
    if (std::isnan(value)) return kNoNumber;
    const double x = std::abs(value);
    if (x > 28.0) return value > 0.0 ? 0.0 : 2.0;
    const double shrunk = exp_of(-exact_product(x, x)) * kOverRootPi;
    if (x < 1.0) {
        double sum = 1.0;
        for (double n = 25.0; n > 0.0; n -= 1.0) sum = 1.0 + x * x * sum / (n + 0.5);
        return 1.0 - 2.0 * value * shrunk * sum;
    }
    double fraction = 0.0;
    for (double n = std::ceil(200.0 / (x * x)) + 10.0; n > 0.0; n -= 1.0) {
        fraction = n / 2.0 / (x + fraction);
    }
    const double tail = shrunk / (x + fraction);
    return value > 0.0 ? tail : 2.0 - tail;
}

}  // namespace tact::portable
