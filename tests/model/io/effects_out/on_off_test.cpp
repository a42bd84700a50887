// What a motor without amplitudes is told: shares of time that follow the amplitude, and rhythms
// that stay.
#include "model/io/effects_out/on_off.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace on_off_test {

using namespace tact;

namespace {

int length_ms(const OnOff& on_off) {
    return std::accumulate(on_off.ms.begin(), on_off.ms.end(), 0);
}

int on_ms(const std::vector<int>& ms) {
    int sum = 0;
    for (std::size_t k = 0; k < ms.size(); k += 2) sum += ms[k];
    return sum;
}

// An amplitude of 0 to 1 for a time.
std::vector<int> held(double amplitude, int for_ms, int coarser = 1) {
    const int step = static_cast<int>(std::lround(255.0 * amplitude));
    return on_off_of({{for_ms}, {step}}, coarser).ms;
}

// But for silence before the first pulse and behind the last one.
void check_floor(const std::vector<int>& ms) {
    for (std::size_t k = 0; k < ms.size(); ++k) {
        const bool is_outside =
            (k == 0 && ms[0] == 0) || (k == 1 && ms[0] == 0) || (k + 1 == ms.size() && k % 2 == 1);
        if (!is_outside) CHECK(ms[k] >= (k % 2 == 0 ? kLeastOnMs : kLeastOffMs));
    }
}

std::vector<double> tone(double hz, double seconds, double rate_hz, double amplitude = 1.0) {
    std::vector<double> samples(static_cast<std::size_t>(std::lround(seconds * rate_hz)));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double t_s = static_cast<double>(n) / rate_hz;
        samples[n] = amplitude * std::sin(2.0 * std::numbers::pi * hz * t_s);
    }
    return samples;
}

SteppedAmplitudes some_steps(std::mt19937& random) {
    const auto whole = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    SteppedAmplitudes steps;
    for (int k = whole(0, 40); k > 0; --k) {
        steps.timings_ms.push_back(whole(0, whole(0, 3) == 0 ? 300 : 30));
        const int kind = whole(0, 3);
        steps.amplitudes.push_back(kind == 0 ? 0 : kind == 1 ? 255 : whole(0, 255));
    }
    return steps;
}

}  // namespace

TEST_CASE("on-off: the share of time of an amplitude is the amplitude") {
    for (int step = 21; step < 243; ++step) {
        const double amplitude = step / 255.0;
        CAPTURE(amplitude);
        // Whole pulses of 10 s: one more or less is 15 ms, above 60 % of full scale 10 ms of pause.
        const double share = on_ms(held(amplitude, 10'000)) / 10'000.0;
        CHECK(std::abs(share - amplitude) <= 0.0015);
    }
    CHECK(held(0.07, 1000) == std::vector{0, 1000});
    CHECK(held(0.96, 1000) == std::vector{1000});
}

TEST_CASE("on-off: up to 60 % pulses are 15 ms, above that pauses are 10 ms") {
    CHECK(held(0.2, 150) == std::vector{15, 60, 15, 60});
    CHECK(held(0.6, 75) == std::vector{15, 10, 15, 10, 15, 10});
    const std::vector<int> strong = held(0.8, 1000);
    REQUIRE(strong.size() > 6);
    for (std::size_t k = 1; k + 1 < strong.size(); k += 2) CHECK(strong[k] == 10);
    CHECK(strong[4] == 40);
}

TEST_CASE("on-off: a stronger amplitude is on for longer") {
    int before_ms = 0;
    for (int percent = 10; percent < 96; percent += 4) {
        const int now_ms = on_ms(held(percent / 100.0, 2000));
        CHECK(now_ms > before_ms);
        before_ms = now_ms;
    }
}

TEST_CASE("on-off: no pulse is under 15 ms, no pause between them under 10, and no ms is lost") {
    std::mt19937 random(48);
    for (int k = 0; k < 2000; ++k) {
        CAPTURE(k);
        const SteppedAmplitudes steps = some_steps(random);
        const int asked_ms = std::accumulate(steps.timings_ms.begin(), steps.timings_ms.end(), 0);
        for (const int coarser : {1, 3}) {
            const OnOff on_off = on_off_of(steps, coarser);
            check_floor(on_off.ms);
            const bool is_lengthened = asked_ms < kLeastOnMs && on_ms(on_off.ms) > 0;
            CHECK(length_ms(on_off) == (is_lengthened ? kLeastOnMs : asked_ms));
            CHECK(on_off == on_off_of(steps, coarser));
        }
    }
}

TEST_CASE("on-off: of a course without pauses the time on is right within a pulse") {
    std::mt19937 random(7);
    for (int round = 0; round < 500; ++round) {
        SteppedAmplitudes steps;
        double asked_ms = 0.0;
        for (int k = 0; k < 30; ++k) {
            steps.timings_ms.push_back(std::uniform_int_distribution<int>(1, 80)(random));
            steps.amplitudes.push_back(std::uniform_int_distribution<int>(21, 242)(random));
            asked_ms += steps.timings_ms.back() * steps.amplitudes.back() / 255.0;
        }
        CHECK(std::abs(on_ms(on_off_of(steps).ms) - asked_ms) <= kLeastOnMs);
    }
}

TEST_CASE("on-off: what is on-off already stays as it is, to the ms") {
    for (const std::vector<int>& ms :
         {std::vector{90, 110, 60, 640, 15, 10, 15}, {0, 3, 20, 10, 1000, 5}, {15}}) {
        SteppedAmplitudes steps;
        for (std::size_t k = 0; k < ms.size(); ++k) {
            steps.timings_ms.push_back(ms[k]);
            steps.amplitudes.push_back(k % 2 == 0 ? 255 : 0);
        }
        CHECK(on_off_of(steps) == OnOff{ms});
    }
}

TEST_CASE("on-off: a tick of 5 ms is 15 ms, wherever it is, and each of a row is there") {
    const OnOff tick = on_off_of({{100, 5, 100}, {0, 255, 0}});
    CHECK(tick.ms == std::vector{0, 100, 15, 90});
    CHECK(tick.lengthened == 1);
    CHECK(tick.floor_lost_s == 0.0);
    CHECK(on_off_of({{5}, {255}}).ms == std::vector{15});
    CHECK(on_off_of({{95, 5}, {0, 255}}).ms == std::vector{0, 85, 15});
    SteppedAmplitudes row;
    for (int k = 0; k < 20; ++k) {
        row.timings_ms.insert(row.timings_ms.end(), {5, 35});
        row.amplitudes.insert(row.amplitudes.end(), {200, 0});
    }
    const OnOff on_off = on_off_of(row);
    CHECK(on_off.lengthened == 20);
    REQUIRE(on_off.ms.size() == 40);
    for (std::size_t k = 0; k < 40; ++k) CHECK(on_off.ms[k] == (k % 2 == 0 ? 15 : 25));
}

TEST_CASE("on-off: of ticks too close to one another some are left out, which is said") {
    SteppedAmplitudes row;
    for (int k = 0; k < 50; ++k) {
        row.timings_ms.insert(row.timings_ms.end(), {5, 13});
        row.amplitudes.insert(row.amplitudes.end(), {255, 0});
    }
    const OnOff on_off = on_off_of(row);
    CHECK(on_off.floor_lost_s > 0.05);
    CHECK(on_off.lengthened + on_off.floor_lost_s / 0.005 == doctest::Approx(50.0));
    check_floor(on_off.ms);
    CHECK(length_ms(on_off) == 900);
}

TEST_CASE("on-off: notes of one strength are equal, and longer pulses keep every note") {
    SteppedAmplitudes steps;
    for (int k = 0; k < 10; ++k) {
        steps.timings_ms.insert(steps.timings_ms.end(), {90, 60});
        steps.amplitudes.insert(steps.amplitudes.end(), {100, 0});
    }
    const std::vector<int> one = held(100.0 / 255.0, 90);
    const std::vector<int> ms = on_off_of(steps).ms;
    for (int k = 0; k < 10; ++k) {
        const auto first = static_cast<std::size_t>(k) * 2 * ((one.size() + 1) / 2);
        for (std::size_t n = 0; n < one.size() - 1; ++n) CHECK(ms[first + n] == one[n]);
    }
    const std::vector<int> coarse = on_off_of(steps, 4).ms;
    CHECK(coarse.size() == 20);
    CHECK(coarse.size() < ms.size());
}

TEST_CASE("on-off: silence is silence, and what is no number is silence too") {
    CHECK(on_off_of({}).ms.empty());
    CHECK(on_off_of({{200}, {0}}).ms == std::vector{0, 200});
    CHECK(on_off_of({{-5, 200}, {255, -3}}).ms == std::vector{0, 200});
    const OnOff faint = on_off_of({{200}, {20}});
    CHECK(faint.ms == std::vector{0, 200});
    CHECK(faint.floor_lost_s == doctest::Approx(0.2));
    const std::vector<double> zeros(2000, 0.0);
    CHECK(on_off_of_drive(zeros, 10'000.0, 1.0).ms == std::vector{0, 200});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double odd : {nan, infinite, -infinite}) {
        CHECK(on_off_of_drive(std::vector(2000, odd), 10'000.0, 1.0).ms == std::vector{0, 200});
        CHECK(on_off_of_drive(tone(160.0, 0.2, 10'000.0), 10'000.0, odd).ms == std::vector{0, 200});
        CHECK(on_off_of_drive(zeros, odd, 1.0).ms.empty());
    }
    CHECK(on_off_of_drive({}, 10'000.0, 1.0).ms.empty());
    CHECK(on_off_of_drive(zeros, 0.0, 1.0).ms.empty());
}

TEST_CASE("on-off: of a drive, a tone of any pitch from 50 Hz on is on for as long as it lasts") {
    for (const double hz : {50.0, 63.0, 110.0, 160.0, 250.0, 400.0}) {
        CAPTURE(hz);
        std::vector<double> drive(1000, 0.0);
        const std::vector<double> sounding = tone(hz, 0.3, 10'000.0);
        drive.insert(drive.end(), sounding.begin(), sounding.end());
        drive.insert(drive.end(), 1000, 0.0);
        const std::vector<int> ms = on_off_of_drive(drive, 10'000.0, 1.0).ms;
        REQUIRE(ms.size() >= 4);
        // A tone comes up to strength within a quarter of a period, and so it ends.
        CHECK(std::abs(ms[1] - 100) <= 2);
        CHECK(std::abs(on_ms(ms) - 300) <= kLeastOnMs);
    }
}

TEST_CASE("on-off: of a drive, the rate does not matter, and the level is a factor") {
    for (const double amplitude : {0.3, 0.7}) {
        const std::vector<int> usual =
            on_off_of_drive(tone(160.0, 1.0, 10'000.0, amplitude), 10'000.0, 1.0).ms;
        for (const double rate_hz : {4'000.0, 8'000.0, 44'100.0, 48'000.0, 192'000.0}) {
            CAPTURE(rate_hz);
            const auto ms = on_off_of_drive(tone(160.0, 1.0, rate_hz, amplitude), rate_hz, 1.0).ms;
            CHECK(std::accumulate(ms.begin(), ms.end(), 0) == 1000);
            // Samples miss the crest of a tone: by 0.8 % of it at 4 kHz and 160 Hz.
            CHECK(std::abs(on_ms(ms) - on_ms(usual)) <= kLeastOnMs);
        }
        const auto half = on_off_of_drive(tone(160.0, 1.0, 10'000.0), 10'000.0, amplitude).ms;
        CHECK(half == usual);
    }
    CHECK(on_off_of_drive(tone(160.0, 1.0, 10'000.0, 3.0), 10'000.0, 1.0).ms == std::vector{1000});
}

}  // namespace on_off_test
