#include "model/pattern/traced.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/pattern/drawn_fault.h"

namespace traced_test {

using namespace tact;

namespace {

double farthest_envelope_g(const Pattern& a, const Pattern& b, double from_s, double to_s) {
    double most_g = 0.0;
    for (double t = from_s; t < to_s; t += 0.001) {
        most_g = std::max(most_g, std::abs(envelope_g(a, t) - envelope_g(b, t)));
    }
    return most_g;
}

}  // namespace

TEST_CASE("traced: a steady tone is a carrier of its frequency and amplitude, with no sweep") {
    for (const double hz : {40.0, 63.0, 150.0, 175.0, 400.0}) {
        Pattern tone;
        tone.amplitude_g = 0.8;
        tone.carriers[0].frequency_hz = hz;
        const TracedPattern got = traced(render(tone));
        CHECK(std::abs(got.pattern.amplitude_g - 0.8) <= 0.03);
        CHECK(std::abs(got.pattern.carriers[0].frequency_hz - hz) <= 1.0);
        CHECK(got.pattern.frequency_curve.empty());
        CHECK(farthest_envelope_g(got.pattern, tone, 0.0, 1.0) <= 0.05);
        CHECK(got.pattern.duration_s == 1.0);
    }
}

TEST_CASE("traced: what was drawn is found again in its samples, as exactly as it is told") {
    Pattern drawn;
    drawn.amplitude_g = 2.0;
    drawn.amplitude_curve = {{0.0, 0.1}, {0.4, 1.0}, {0.7, 0.3}, {1.0, 0.9}};
    drawn.frequency_curve = {{0.0, 80.0}, {0.5, 250.0}, {1.0, 250.0}};
    const TracedPattern got = traced(render(drawn));
    CHECK(!drawn_fault(got.pattern));
    CHECK(got.pattern.amplitude_curve.size() <= 60);
    // The mean of 10 ms rounds the corners off, and half cycles of another frequency ripple.
    CHECK(farthest_envelope_g(got.pattern, drawn, 0.0, 1.0) <= 0.1);
    CHECK(got.amplitude_error_g <= 0.02 + 1e-12);
    CHECK(got.frequency_error_hz <= 1.0 + 1e-12);
    for (double t = 0.05; t < 0.95; t += 0.01) {
        CHECK(std::abs(first_carrier_hz(got.pattern, t) - first_carrier_hz(drawn, t)) <= 6.0);
    }
}

TEST_CASE("traced: fewer points are obeyed, and cost what the errors say") {
    Pattern drawn;
    drawn.amplitude_curve = {{0.0, 0.0}, {0.25, 1.0}, {0.5, 0.0}, {0.75, 1.0}, {1.0, 0.0}};
    const Waveform recording = render(drawn);
    const TracedPattern fine = traced(recording);
    const TracedPattern coarse = traced(recording, {3, 0.01, 1.0});
    CHECK(coarse.pattern.amplitude_curve.size() == 3);
    CHECK(fine.amplitude_error_g <= 0.011);
    CHECK(coarse.amplitude_error_g > 0.4);
}

TEST_CASE("traced: pauses have no frequency of their own") {
    Pattern beats;
    beats.carriers[0].frequency_hz = 120.0;
    beats.rhythm = {"x-", 0.25};
    const TracedPattern got = traced(render(beats));
    CHECK(std::abs(first_carrier_hz(got.pattern, 0.125) - 120.0) <= 2.0);
    CHECK(std::abs(first_carrier_hz(got.pattern, 0.375) - 120.0) <= 15.0);
    CHECK(envelope_g(got.pattern, 0.375) <= 1e-6);
}

TEST_CASE("traced: silence, nothing and a single sample give patterns without curves or NaN") {
    const TracedPattern silent = traced({48'000.0, std::vector<double>(4800, 0.0)});
    CHECK(silent.pattern.amplitude_g == 0.0);
    CHECK(!is_drawn(silent.pattern));
    CHECK(traced({48'000.0, {}}).pattern.amplitude_g == 0.0);
    CHECK(!drawn_fault(traced({48'000.0, {0.5}}).pattern));
    CHECK(!drawn_fault(traced({10'000.0, std::vector<double>(5000, 0.7)}).pattern));
}

TEST_CASE(
    "traced: a tone of a few milliseconds is its frequency and strength, and called a guess") {
    for (const double rate_hz : {10'000.0, 48'000.0}) {
        for (const double hz : {60.0, 100.0, 250.0, 400.0}) {
            for (const double length_ms : {3.0, 5.0, 8.0, 12.0, 25.0, 30.0, 35.0, 45.0}) {
                if (hz * length_ms < 900.0) continue;  // less than a cycle tells little
                CAPTURE(rate_hz);
                CAPTURE(hz);
                CAPTURE(length_ms);
                Pattern tone;
                tone.amplitude_g = 0.8;
                tone.carriers[0].frequency_hz = hz;
                tone.carriers[0].phase_rad = 0.7;
                tone.duration_s = 1e-3 * length_ms;
                const TracedPattern got = traced(render(tone, rate_hz));
                CHECK(std::abs(got.pattern.carriers[0].frequency_hz - hz) <= 0.01 * hz);
                CHECK(std::abs(got.pattern.amplitude_g - 0.8) <= 0.04);
                CHECK(got.pattern.frequency_curve.empty());
                CHECK(got.pattern.duration_s == doctest::Approx(tone.duration_s));
                if (length_ms < 40.0) CHECK(got.frequency_is_a_guess);
            }
        }
    }
    Pattern long_enough;
    CHECK_FALSE(traced(render(long_enough)).frequency_is_a_guess);
}

TEST_CASE("traced: a tone with whole half cycles in 10 ms comes out flat, at every rate") {
    for (const double rate_hz : {8'000.0, 10'000.0, 44'100.0, 48'000.0}) {
        for (const double hz : {50.0, 100.0, 150.0, 200.0, 350.0}) {
            CAPTURE(rate_hz);
            CAPTURE(hz);
            Pattern tone;
            tone.duration_s = 0.3;
            tone.carriers[0].frequency_hz = hz;
            const TracedPattern got = traced(render(tone, rate_hz), {60, 1e-5, 1.0});
            double least = 1e9;
            double most = 0.0;
            for (double t = 0.02; t < 0.28; t += 0.001) {
                least = std::min(least, envelope_g(got.pattern, t));
                most = std::max(most, envelope_g(got.pattern, t));
            }
            CHECK(most - least <= 1e-3);
        }
    }
}

}  // namespace traced_test
