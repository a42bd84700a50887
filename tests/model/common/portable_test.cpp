#include "model/common/portable.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "model/common/random.h"
#include "tests/support/golden.h"

namespace portable_test {

using namespace tact;

namespace {

using Function = std::function<double(double)>;

const std::map<std::string, Function> kFunctions{
    {"sin", [](double x) { return portable::sin(x); }},
    {"cos", [](double x) { return portable::cos(x); }},
    {"tan", [](double x) { return portable::tan(x); }},
    {"atan", [](double x) { return portable::atan(x); }},
    {"exp", [](double x) { return portable::exp(x); }},
    {"log", [](double x) { return portable::log(x); }},
    {"log2", [](double x) { return portable::log2(x); }},
    {"log10", [](double x) { return portable::log10(x); }},
    {"pow10", [](double x) { return portable::pow(10.0, x); }},
    {"erfc", [](double x) { return portable::erfc(x); }},
};

double number_of(const golden::Json& hex) { return std::stod(hex.get<std::string>()); }

bool same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b && std::signbit(a) == std::signbit(b);
}

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kOdd[] = {0.0,  -0.0,  1.0,  -1.0,   2.0,    -2.0,  0.5,    -3.0, 1e300,
                           kInf, -kInf, kNan, 5e-324, 1e-310, 1e308, -745.1, 709.7};

}  // namespace

TEST_CASE("portable: results are the nearest double, as sixty digits rounded are") {
    const golden::Json table = golden::read("portable.json");
    for (const auto& [name, function] : kFunctions) {
        CAPTURE(name);
        REQUIRE(table.at(name).size() >= 40);
        for (const golden::Json& row : table.at(name)) {
            const double x = number_of(row[0]);
            const double expected = number_of(row[1]);
            CAPTURE(x);
            if (name != "erfc") {
                CHECK(function(x) == expected);
                continue;
            }
            CHECK(std::abs(function(x) - expected) <= 10.0 * 0x1p-52 * expected);
        }
    }
}

TEST_CASE("portable: what is a whole number of digits comes out whole") {
    for (int k = -300; k <= 300; ++k) {
        CAPTURE(k);
        CHECK(portable::log2(std::ldexp(1.0, k)) == k);
        CHECK(portable::pow(2.0, k) == std::ldexp(1.0, k));
        if (k >= 0 && k <= 22) {
            const double power = std::stod("1e" + std::to_string(k));
            CHECK(portable::log10(power) == k);
            CHECK(portable::pow(10.0, k) == power);
        }
    }
}

TEST_CASE("portable: zeros, infinities and what is no number give what std:: gives") {
    for (const double a : kOdd) {
        CAPTURE(a);
        CHECK(same(portable::exp(a), std::exp(a)));
        CHECK(same(portable::log(a), std::log(a)));
        CHECK(same(portable::log2(a), std::log2(a)));
        CHECK(same(portable::atan(a), std::atan(a)));
        CHECK(std::isnan(portable::sin(a)) == !std::isfinite(a));
        CHECK(std::isnan(portable::cos(a)) == !std::isfinite(a));
        CHECK(std::isnan(portable::erfc(a)) == std::isnan(a));
        if (std::abs(a) < 1e-300) CHECK(same(portable::sin(a), a));
        if (std::abs(a) < 1e-300) CHECK(same(portable::tan(a), a));
        if (std::isinf(a)) CHECK(same(portable::erfc(a), std::erfc(a)));
        for (const double b : kOdd) {
            CAPTURE(b);
            // Far from 1 the last digits are checked elsewhere.
            const double power = std::pow(a, b);
            if (power == 0.0 || !std::isfinite(power) || power == 1.0) {
                CHECK(same(portable::pow(a, b), power));
            }
            CHECK(std::isnan(portable::hypot(a, b)) == std::isnan(std::hypot(a, b)));
            if (std::isinf(a)) CHECK(same(portable::hypot(a, b), kInf));
        }
    }
    CHECK(portable::pow(-2.0, 3.0) == -8.0);
    CHECK(portable::pow(-2.0, 4.0) == 16.0);
}

TEST_CASE("portable: a sine is odd, and with its cosine on the circle, near and far") {
    for (const double angle : {1e-8, 0.3, 0.7853981633974483, 2.0, 1e3, 6.5e6, 6.7e6, 1e9, 1e13}) {
        CAPTURE(angle);
        const double sine = portable::sin(angle);
        const double cosine = portable::cos(angle);
        CHECK(portable::sin(-angle) == -sine);
        CHECK(portable::cos(-angle) == cosine);
        CHECK(std::abs(sine * sine + cosine * cosine - 1.0) <= 4e-16);
        CHECK(std::abs(sine - std::sin(angle)) <= 0x1p-52 * std::abs(sine));
        CHECK(portable::polar(2.0, angle) == std::complex<double>(2.0 * cosine, 2.0 * sine));
    }
}

TEST_CASE(
    "portable: a point on the circle has the sine and the cosine of its angle, odd ones too") {
    for (const double angle : {0.0, -0.0, 5e-324, 1e-9, -0.7, 1.6, 6.6e6, -6.8e6, 1e12, 1e300}) {
        CAPTURE(angle);
        const std::complex<double> point = portable::polar(1.0, angle);
        CHECK(same(point.real(), portable::cos(angle)));
        CHECK(same(point.imag(), portable::sin(angle)));
    }
    for (const double angle : {kInf, -kInf, kNan}) {
        CHECK(std::isnan(portable::polar(1.0, angle).real()));
        CHECK(std::isnan(portable::polar(1.0, angle).imag()));
    }
}

TEST_CASE(
    "portable: a length is the same digits however large, and within 0.505 units of the true") {
    RandomStream random{11};
    for (int turn = 0; turn < 20'000; ++turn) {
        const double a = std::ldexp(next_even(random), turn % 60 - 30);
        const double b = next_even(random);
        CAPTURE(a);
        CAPTURE(b);
        const double length = portable::hypot(a, b);
        // Across the sizes from which on squares are scaled, and near the ends of what there is.
        for (const int k : {-900, -401, -400, -399, 399, 400, 401, 900}) {
            CHECK(portable::hypot(std::ldexp(a, k), std::ldexp(b, k)) == std::ldexp(length, k));
        }
        CHECK(portable::hypot(-b, a) == length);
        // Eleven more bits, so that they are off by a thousandth of a unit.
        const auto wide = [](double x) { return static_cast<long double>(x); };
        const long double truth = std::sqrt(wide(a) * wide(a) + wide(b) * wide(b));
        const double unit = std::ldexp(1.0, std::ilogb(length) - 52);
        CHECK(std::abs(wide(length) - truth) <= 0.505L * wide(unit));
    }
}

TEST_CASE("portable: lengths and roots of complex numbers") {
    CHECK(portable::hypot(3.0, -4.0) == 5.0);
    CHECK(portable::hypot(std::ldexp(3.0, 700), std::ldexp(4.0, 700)) == std::ldexp(5.0, 700));
    CHECK(portable::hypot(3e-310, 4e-310) == doctest::Approx(5e-310).epsilon(1e-12));
    CHECK(portable::abs({5.0, 12.0}) == 13.0);
    for (const std::complex<double> z :
         {std::complex(3.0, 4.0), std::complex(-3.0, 4.0), std::complex(-3.0, -4.0),
          std::complex(-9.0, 0.0), std::complex(-9.0, -0.0), std::complex(0.0, 2.0)}) {
        CAPTURE(z.real());
        CAPTURE(z.imag());
        CHECK(std::abs(portable::sqrt(z) - std::sqrt(z)) <= 4e-16 * std::abs(z));
    }
    CHECK(portable::sqrt({0.0, 0.0}) == std::complex(0.0, 0.0));
}

}  // namespace portable_test
