#include "devices/device/supply.h"

#include <doctest/doctest.h>

namespace supply_test {

using namespace tact;

namespace {

constexpr double kPeriodS = 0.005;
constexpr double kBufferS = 0.02;

// An output that keeps four periods and asks for one each time that it has played one, `late_s`
// after that. It fills up at once.
struct Output {
    Supply supply{.lasts_s = kBufferS};
    double now_s = 7.0;
    int gaps = 0;

    Output() {
        for (int k = 0; k < 4; ++k) ask(0.0);
    }
    void ask(double late_s) { gaps += has_run_dry(supply, now_s + late_s, kPeriodS) ? 1 : 0; }
    void play(double late_s, double rate = 1.0) {
        now_s += kPeriodS / rate;
        ask(late_s);
    }
};

}  // namespace

TEST_CASE("supply: calls that are late by less than what was rendered lasts are no gap") {
    Output output;
    for (int k = 0; k < 4000; ++k) output.play(k % 7 == 0 ? 0.9 * kBufferS : 0.0002 * (k % 3));
    CHECK(output.gaps == 0);
}

TEST_CASE("supply: what runs dry is a gap, however short, and one only") {
    for (const double missing_s : {0.0005, 0.003, 0.2, 5.0}) {
        CAPTURE(missing_s);
        Output output;
        for (int k = 0; k < 1000; ++k) output.play(0.0001 * (k % 5));
        output.now_s += missing_s;  // all that follows is heard later
        output.play(kBufferS + 0.0002);
        for (int k = 0; k < 1000; ++k) output.play(0.0001 * (k % 5));
        CHECK(output.gaps == 1);
        output.now_s += missing_s;
        output.play(kBufferS + 0.0002);
        CHECK(output.gaps == 2);
    }
}

TEST_CASE("supply: a card whose seconds are others has no gaps within ten minutes") {
    for (const double rate : {1.0 - 300e-6, 1.0 + 300e-6}) {
        CAPTURE(rate);
        Output output;
        for (int k = 0; k < 120'000; ++k) output.play(k % 7 == 0 ? 0.01 : 0.0, rate);
        CHECK(output.gaps == 0);
    }
}

}  // namespace supply_test
