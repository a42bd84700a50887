#include "model/pattern/curves.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "model/pattern/drawn_fault.h"

namespace curves_test {

using namespace tact;

namespace {

std::string fault_of(const Pattern& pattern) {
    const auto fault = drawn_fault(pattern);
    return fault ? sentence(*fault) : "";
}

}  // namespace

TEST_CASE("curves: straight between points, held before and after, and a jump is at its time") {
    const AmplitudeCurve curve{{0.2, 0.0}, {0.4, 1.0}, {0.4, 0.5}, {0.8, 0.25}};
    CHECK(value_at(curve, 0.0) == 0.0);
    CHECK(std::abs(value_at(curve, 0.25) - 0.25) <= 1e-15);
    CHECK(value_at(curve, std::nextafter(0.4, 0.0)) > 0.999);
    CHECK(value_at(curve, 0.4) == 0.5);
    CHECK(std::abs(value_at(curve, 0.6) - 0.375) <= 1e-15);
    CHECK(value_at(curve, 60.0) == 0.25);
    CHECK(value_at(AmplitudeCurve{}, 0.3) == 1.0);
    CHECK(!frequency_at({}, 0.3));
    CHECK(frequency_at({{0.0, 100.0}, {1.0, 200.0}}, 0.25) == 125.0);
}

TEST_CASE("curves: turns are the area under the frequency") {
    const Sweep sweep = sweep_of({{0.1, 50.0}, {0.3, 150.0}, {0.3, 400.0}, {0.5, 400.0}});
    CHECK(std::abs(turns_at(sweep, 0.05) - 2.5) <= 1e-12);
    CHECK(std::abs(turns_at(sweep, 0.2) - (5.0 + 7.5)) <= 1e-12);
    CHECK(std::abs(turns_at(sweep, 0.3) - (5.0 + 20.0)) <= 1e-12);
    CHECK(std::abs(turns_at(sweep, 0.4) - (25.0 + 40.0)) <= 1e-12);
    CHECK(std::abs(turns_at(sweep, 1.5) - (25.0 + 480.0)) <= 1e-12);
}

TEST_CASE("curves: points as close as numbers can be give numbers") {
    const Sweep sweep = sweep_of({{0.0, 1.0}, {5e-324, 1000.0}});
    CHECK(turns_at(sweep, 0.0) == 0.0);
    CHECK(std::isfinite(turns_at(sweep, 1.0)));
    CHECK(value_at(AmplitudeCurve{{0.0, 0.0}, {5e-324, 1.0}}, 0.0) == 0.0);
}

TEST_CASE("curves: a transient begins and ends at nothing, and is its sine in between") {
    const Transient burst{0.5, 2.0, 200.0, 0.02, TransientShape::sine};
    CHECK(transient_g(burst, -1e-9) == 0.0);
    CHECK(transient_g(burst, 0.0) == 0.0);
    CHECK(transient_g(burst, 0.02) == 0.0);
    for (double t = 0.0051; t < 0.0149; t += 0.0007) {
        CHECK(std::abs(transient_g(burst, t) - 2.0 * std::sin(400.0 * std::numbers::pi * t)) <=
              1e-12);
    }
    // Half way up the flank of 5 ms the window is 1/2; the sine is at its peak a turn's quarter in.
    const Transient slow{0.0, 2.0, 100.0, 0.02, TransientShape::sine};
    CHECK(std::abs(transient_g(slow, 0.0025) - 0.5 * 2.0 * std::sin(0.5 * std::numbers::pi)) <=
          1e-12);
}

TEST_CASE("curves: a square transient has the same window, and its edges on the half turns") {
    const Transient burst{0.0, 3.0, 250.0, 0.02, TransientShape::square};
    for (int n = 50; n < 150; ++n) {  // in 20 samples a half turn
        const double t = n / 10'000.0;
        CHECK(transient_g(burst, t) == (n / 20 % 2 == 0 ? 3.0 : -3.0));
    }
    CHECK(transient_g(burst, 0.0) == 0.0);
    CHECK(std::abs(transient_g(burst, 0.0001)) < 0.01);
    CHECK(std::abs(transient_g(burst, 0.0199)) < 0.01);
}

TEST_CASE("curves: an inserted point changes nothing, until it would be the third at one time") {
    AmplitudeCurve curve{{0.0, 0.0}, {1.0, 1.0}};
    CHECK(insert_point(curve, 0.25) == 1);
    CHECK(curve[1] == AmplitudePoint{0.25, 0.25});
    CHECK(insert_point(curve, 0.25) == 2);
    CHECK(!insert_point(curve, 0.25));
    FrequencyCurve empty;
    CHECK(insert_point(empty, 0.5, 90.0) == 0);
    CHECK(empty.front() == FrequencyPoint{0.5, 90.0});
    AmplitudeCurve full(limits::kMaxCurvePoints);
    CHECK(!insert_point(full, 0.5));
}

TEST_CASE("curves: a point may go anywhere between its neighbours, and make a jump but no more") {
    AmplitudeCurve curve{{0.0, 1.0}, {0.0, 0.5}, {0.4, 1.0}, {0.6, 0.2}, {0.6, 0.9}};
    for (std::size_t k = 0; k < curve.size(); ++k) {
        const Range times = room_of(curve, k, 1.0);
        CHECK(times.contains(curve[k].time_s));
        for (const double time_s : {times.low, times.high}) {
            Pattern pattern;
            pattern.amplitude_curve = curve;
            pattern.amplitude_curve[k].time_s = time_s;
            CHECK_MESSAGE(fault_of(pattern).empty(), k << ": " << fault_of(pattern));
        }
    }
    CHECK(room_of(curve, 4, 1.0) == Range{0.6, 1.0});
    CHECK(room_of(curve, 2, 1.0).low > 0.0);
    CHECK(room_of(curve, 2, 1.0).high < 0.6);
    CHECK(room_of(FrequencyCurve{{0.3, 100.0}, {0.7, 90.0}}, 1, 1.0) == Range{0.3, 1.0});
}

TEST_CASE("curves: what is cut keeps its course up to the end") {
    AmplitudeCurve curve{{0.0, 0.0}, {1.0, 1.0}};
    cut_at(curve, 0.25);
    CHECK(curve == AmplitudeCurve{{0.0, 0.0}, {0.25, 0.25}});
    cut_at(curve, 0.25);
    CHECK(curve.size() == 2);
    FrequencyCurve late{{0.5, 100.0}, {0.9, 50.0}};
    cut_at(late, 0.2);
    CHECK(late == FrequencyCurve{{0.2, 100.0}});
}

TEST_CASE("drawn fault: every rule is refused with its place, and what obeys all is not") {
    const auto with = [](auto change) {
        Pattern pattern;
        pattern.amplitude_curve = {{0.0, 0.0}, {0.5, 1.0}, {0.5, 0.5}, {1.0, 0.0}};
        pattern.frequency_curve = {{0.0, 0.1}, {1.0, 1000.0}};
        pattern.transients = {{0.9, 1.0, 100.0, 0.5, TransientShape::square}, {0.1}};
        change(pattern);
        return fault_of(pattern);
    };
    CHECK(with([](Pattern&) {}).empty());
    CHECK(with([](Pattern& p) { p.amplitude_curve[1].value = 1.5; }) ==
          "amplitude_curve/1/value: expected a number from 0 to 1, got 1.5");
    CHECK(with([](Pattern& p) { p.amplitude_curve[3].time_s = 1.25; }) ==
          "amplitude_curve/3/time_s: expected a time within the pattern, 0 to 1 s, got 1.25");
    CHECK(with([](Pattern& p) { p.amplitude_curve[3].time_s = 0.25; }) ==
          "amplitude_curve/3/time_s: expected a time not before the last point's 0.5 s, got 0.25");
    CHECK(with([](Pattern& p) { p.amplitude_curve[3].time_s = 0.5; }) ==
          "amplitude_curve/3/time_s: expected at most two points at one time, a jump, got 0.5");
    CHECK(with([](Pattern& p) {
              p.amplitude_curve = {{0.5}, {0.5}, {0.5}};
          }).starts_with("amplitude_curve/2/time_s: expected at most two"));
    CHECK(with([](Pattern& p) { p.frequency_curve[1].frequency_hz = 0.0; }) ==
          "frequency_curve/1/frequency_hz: expected a number from 0.1 to 1000, got 0");
    CHECK(with([](Pattern& p) {
              p.frequency_curve[0].time_s = -0.5;
          }).starts_with("frequency_curve/0/time_s: "));
    CHECK(with([](Pattern& p) {
              p.transients[1].time_s = std::nan("");
          }).starts_with("transients/1/time_s: "));
    CHECK(with([](Pattern& p) {
              p.transients[1].duration_s = 0.0;
          }).starts_with("transients/1/duration_s: "));
    CHECK(with([](Pattern& p) {
              p.transients[1].amplitude_g = 51.0;
          }).starts_with("transients/1/amplitude_g: "));
    CHECK(with([](Pattern& p) {
              p.transients[1].frequency_hz = 1001.0;
          }).starts_with("transients/1/frequency_hz: "));
    CHECK(with([](Pattern& p) { p.transients.resize(10'001); }) ==
          "transients: expected at most 10,000 transients, got 10001");
    CHECK(with([](Pattern& p) { p.frequency_curve.resize(100'001); }) ==
          "frequency_curve: expected at most 100,000 points, got 100001");
}

}  // namespace curves_test
