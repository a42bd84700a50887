#include <array>
#include <cmath>
#include <cstdint>

#include "model/common/double_double.h"
#include "model/common/portable.h"

namespace tact::portable {

namespace {

// An angle is k steps of pi / 32 and a rest of at most half a step.
constexpr std::size_t kStepsOfTurn = 64;
constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// sin x = x - x^3/3! + x^5/5! - ... of 0 <= x <= pi/4.
constexpr DoubleDouble sine_series(DoubleDouble x) {
    const DoubleDouble square = x * x;
    DoubleDouble sum{1.0, 0.0};
    for (double n = 26.0; n > 0.0; n -= 2.0) {
        sum = DoubleDouble{1.0, 0.0} - square * sum / DoubleDouble{n * (n + 1.0), 0.0};
    }
    return x * sum;
}

constexpr DoubleDouble cosine_series(DoubleDouble x) {
    const DoubleDouble square = x * x;
    DoubleDouble sum{1.0, 0.0};
    for (double n = 26.0; n > 0.0; n -= 2.0) {
        sum = DoubleDouble{1.0, 0.0} - square * sum / DoubleDouble{n * (n - 1.0), 0.0};
    }
    return sum;
}

constexpr DoubleDouble sine_of_step(std::size_t step) {
    if (step >= kStepsOfTurn / 2) return -sine_of_step(step - kStepsOfTurn / 2);
    if (step > kStepsOfTurn / 4) return sine_of_step(kStepsOfTurn / 2 - step);
    const auto steps = [](std::size_t k) {
        return kPi * DoubleDouble{static_cast<double>(k) / 32.0, 0.0};
    };
    return step <= kStepsOfTurn / 8 ? sine_series(steps(step))
                                    : cosine_series(steps(kStepsOfTurn / 4 - step));
}

constexpr auto kSine = [] {
    std::array<DoubleDouble, kStepsOfTurn> sine{};
    for (std::size_t step = 0; step < kStepsOfTurn; ++step) sine[step] = sine_of_step(step);
    return sine;
}();

struct Reduced {
    std::size_t step = 0;
    DoubleDouble rest_rad;
};

// pi / 32 in pieces: the first three times a whole number below 2^26 are exact.
constexpr std::array<double, 4> kPieces{0x1.921fb5p-4, 0x1.110b46p-30, 0x1.1a6263p-58,
                                        0x1.8a2e03707344ap-85};
constexpr double kFewSteps = 0x1p26;
constexpr double kStepsARad = 0x1.45f306dc9c883p+3;
constexpr double kRounds = 0x1.8p52;  // plus and minus it is the nearest whole number
constexpr double kFarthestRad = 0x1p48;

Reduced reduced(double angle_rad) {
    if (std::abs(angle_rad) > kFarthestRad) angle_rad = std::fmod(angle_rad, 2.0 * kPi.high);
    const double k = (angle_rad * kStepsARad + kRounds) - kRounds;
    Reduced result;
    result.step = static_cast<std::size_t>(static_cast<std::int64_t>(k)) % kStepsOfTurn;
    if (std::abs(k) < kFewSteps) {
        const DoubleDouble first = exact_sum(angle_rad - k * kPieces[0], -k * kPieces[1]);
        const DoubleDouble second = exact_sum(first.high, -k * kPieces[2]);
        result.rest_rad = quick_sum(second.high, second.low + first.low - k * kPieces[3]);
        return result;
    }
    constexpr std::array<double, 3> kLongPieces{0x1.921fb54442d18p-4, 0x1.1a62633145c07p-58,
                                                -0x1.f1976b7ed8fbcp-114};
    result.rest_rad = {angle_rad, 0.0};
    for (const double piece : kLongPieces) {
        result.rest_rad = result.rest_rad - exact_product(k, piece);
    }
    return result;
}

// sin(a + r) = sin a + cos a sin r + sin a (cos r - 1), a in steps. What is not exact is a
// thousandth of the result or less.
DoubleDouble sine_of(const Reduced& angle, std::size_t quarter_turn) {
    const DoubleDouble& sine = kSine[(angle.step + quarter_turn) % kStepsOfTurn];
    const DoubleDouble& cosine =
        kSine[(angle.step + quarter_turn + kStepsOfTurn / 4) % kStepsOfTurn];
    const double r = angle.rest_rad.high;
    const double square = r * r;
    const double beyond_r =
        r * square *
        (-1.0 / 6.0 + square * (1.0 / 120.0 + square * (-1.0 / 5040.0 + square / 362'880.0)));
    const double below_1 =
        square * (-0.5 + square * (1.0 / 24.0 + square * (-1.0 / 720.0 + square / 40'320.0)));
    const DoubleDouble turned = exact_product(cosine.high, r);
    const DoubleDouble sum = exact_sum(sine.high, turned.high);
    const double rest = cosine.high * (angle.rest_rad.low + beyond_r) + cosine.low * r +
                        sine.high * (below_1 - r * angle.rest_rad.low) + sine.low + turned.low;
    return quick_sum(sum.high, sum.low + rest);
}

constexpr std::size_t kNone = 0;
constexpr std::size_t kQuarter = kStepsOfTurn / 4;

double root_of_squares(double a, double b) {
    const DoubleDouble squares = exact_product(a, a) + exact_product(b, b);
    const double root = std::sqrt(squares.high);
    const DoubleDouble of_root = exact_product(root, root);
    const double apart = squares.high - of_root.high;  // exact: they are as good as equal
    const DoubleDouble low = exact_sum(squares.low, -of_root.low);
    const DoubleDouble short_of = quick_sum(apart, low.high);
    return root + (short_of.high + (short_of.low + low.low)) / (2.0 * root);
}

bool is_tiny(double angle_rad) { return std::abs(angle_rad) < 0x1p-27; }

}  // namespace

double sin(double angle_rad) {
    if (!std::isfinite(angle_rad)) return std::nan("");
    if (is_tiny(angle_rad)) return angle_rad;  // -0 and the faintest, too
    return sine_of(reduced(angle_rad), kNone).high;
}

double cos(double angle_rad) {
    if (!std::isfinite(angle_rad)) return std::nan("");
    return sine_of(reduced(angle_rad), kQuarter).high;
}

double tan(double angle_rad) {
    if (!std::isfinite(angle_rad)) return std::nan("");
    if (is_tiny(angle_rad)) return angle_rad;
    const Reduced angle = reduced(angle_rad);
    return (sine_of(angle, kNone) / sine_of(angle, kQuarter)).high;
}

// What a guess y is short of: atan v - y = atan((v cos y - sin y) / (cos y + v sin y)).
double atan(double value) {
    const double length = std::abs(value);
    if (!(length >= 0x1p-27)) return value;  // and NaN
    const auto guess = [](double v) { return v / (1.0 + 0.28 * v * v); };
    double angle = length <= 1.0 ? guess(length) : kPi.high / 2.0 - guess(1.0 / length);
    if (length > 0x1p60) return std::copysign(kPi.high / 2.0, value);
    for (int step = 0; step < 3; ++step) {
        const Reduced at = reduced(angle);
        const DoubleDouble sine = sine_of(at, kNone);
        const DoubleDouble cosine = sine_of(at, kQuarter);
        const DoubleDouble v{length, 0.0};
        const double off = ((v * cosine - sine) / (cosine + v * sine)).high;
        angle += off - off * off * off / 3.0;
    }
    return std::copysign(angle, value);
}

double hypot(double a, double b) {
    a = std::abs(a);
    b = std::abs(b);
    const double larger = a > b ? a : b;
    if (larger >= 0x1p-400 && larger <= 0x1p400) return root_of_squares(a, b);
    if (std::isinf(a) || std::isinf(b)) return HUGE_VAL;
    if (!(larger > 0.0)) return a + b;  // 0 or NaN
    // By a power of two, so that no square over- or underflows.
    const int exponent = std::ilogb(larger);
    return std::ldexp(root_of_squares(std::ldexp(a, -exponent), std::ldexp(b, -exponent)),
                      exponent);
}

double abs(std::complex<double> value) { return hypot(value.real(), value.imag()); }

std::complex<double> polar(double length, double angle_rad) {
    if (!std::isfinite(angle_rad)) return {std::nan(""), std::nan("")};
    const Reduced angle = reduced(angle_rad);
    const double sine = is_tiny(angle_rad) ? angle_rad : sine_of(angle, kNone).high;
    return {length * sine_of(angle, kQuarter).high, length * sine};
}

std::complex<double> sqrt(std::complex<double> value) {
    const double half = std::sqrt((abs(value) + std::abs(value.real())) / 2.0);
    if (half == 0.0) return {0.0, value.imag()};
    const double other = value.imag() / (2.0 * half);
    if (value.real() >= 0.0) return {half, other};
    return {std::abs(other), std::copysign(half, value.imag())};
}

}  // namespace tact::portable
