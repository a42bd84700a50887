// How far an actuator moves over plays in turn, loops, changes and stops: laws, each computed here
// again from what has left the stream, by a mass on a spring in steps of its own.
#include "devices/device/travel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/device/playback.h"
#include "model/signal/waveform.h"
#include "tests/support/one_channel.h"

namespace travel_test {

using namespace tact;

namespace {

constexpr double kRateHz = 8000.0;
constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kLimitMm = 0.5;

// 1 g per full scale from `low_hz` on.
Calibration flat_from(double low_hz) {
    Calibration calibration;
    for (double f_hz = low_hz; f_hz < 520.0; f_hz *= std::exp2(1.0 / 3.0)) {
        calibration.points.push_back({f_hz, 1.0});
    }
    calibration.excursion_limit_mm = kLimitMm;
    return calibration;
}

Drive tone(const Calibration& calibration, double f_hz, double duration_s, double phase,
           bool loop = false) {
    Waveform waveform;
    for (std::size_t n = 0; n < sample_count(duration_s, waveform.rate_hz); ++n) {
        const double t_s = static_cast<double>(n) / waveform.rate_hz;
        waveform.samples_g.push_back(0.5 * std::sin(kTau * f_hz * t_s + phase));
    }
    return calibrated_drive(waveform, calibration, loop).drive;
}

// x'' = a - 2 z w x' - w^2 x in steps of an eighth of a sample: semi-implicit, no formula of
// travel.h.
double farthest_mm(const std::vector<float>& drive, double f0_hz) {
    const double w = kTau * f0_hz;
    const double step_s = 1.0 / (8.0 * kRateHz);
    double x_mm = 0.0;
    double v_mm_s = 0.0;
    double most_mm = 0.0;
    for (const float sample : drive) {
        for (int k = 0; k < 8; ++k) {
            v_mm_s += step_s * (9806.65 * static_cast<double>(sample) -
                                std::numbers::sqrt2 * w * v_mm_s - w * w * x_mm);
            x_mm += step_s * v_mm_s;
        }
        most_mm = std::max(most_mm, std::abs(x_mm));
    }
    return most_mm;
}

// Blocks of 1 ms.
struct Out : one_channel::Out {
    Out() : one_channel::Out(kRateHz, 8) {}
};

double reach_hz(double low_hz) { return low_hz * std::exp2(-1.0 / 3.0); }

}  // namespace

TEST_CASE("travel: plays in turn move it no farther than one may, at the worst phase") {
    for (const double low_hz : {2.0, 8.0, 20.0}) {
        const Calibration calibration = flat_from(low_hz);
        for (const double times : {1.0, 1.5, 2.4}) {
            for (const double phase : {0.0, 1.6, 3.1, 4.7}) {
                CAPTURE(low_hz);
                CAPTURE(times);
                CAPTURE(phase);
                const double f_hz = times * low_hz;
                Out out;
                for (int k = 0; k < 3; ++k) {
                    out.play(tone(calibration, f_hz, 2.25 / f_hz, phase * k));
                    out.run_to_its_end();
                }
                out.run(1.0);
                CHECK(farthest_mm(out.left, reach_hz(low_hz)) <= 1.04 * kLimitMm);
            }
        }
    }
}

TEST_CASE("travel: a loop's start, rounds, stops and changes keep to it together") {
    const Calibration calibration = flat_from(5.0);
    double most_mm = 0.0;
    for (const double length_s : {0.1, 0.23, 0.4, 1.0}) {
        for (const double changed_s : {0.6, 0.63, 0.66, 0.7, 0.74}) {
            CAPTURE(length_s);
            CAPTURE(changed_s);
            Out out;
            out.play(tone(calibration, 9.0, length_s, 0.0, true), true);
            out.run(changed_s);
            out.change(tone(calibration, 6.0, length_s, 2.5, true));
            out.run(changed_s + 0.4);
            out.playback.wanted = nullptr;
            out.run(1.0);
            const double moved_mm = farthest_mm(out.left, reach_hz(5.0));
            CHECK(moved_mm <= 1.06 * kLimitMm);
            most_mm = std::max(most_mm, moved_mm);
        }
    }
    CHECK(most_mm > 0.7 * kLimitMm);  // nor is more taken away than has to be
}

TEST_CASE("travel: what was held back for it is told, and back when the motion is over") {
    const Calibration calibration = flat_from(5.0);
    Out out;
    out.play(tone(calibration, 5.0, 0.25, 0.0));
    out.run_to_its_end();
    float kept = 1.0F;
    for (const double phase : {0.0, 1.6, 3.1, 4.7}) {
        out.play(tone(calibration, 5.0, 0.25, phase));
        out.run_to_its_end();
        kept = std::min(kept, notes_of(out.playback, out.serial).kept.load());
    }
    CHECK(kept < 0.9F);
    out.run(1.0);
    out.play(tone(calibration, 5.0, 0.25, 0.0));
    out.run_to_its_end();
    CHECK(notes_of(out.playback, out.serial).kept >= 0.98F);
}

TEST_CASE("travel: without a limit nothing is computed, and nothing held back") {
    Calibration calibration = flat_from(5.0);
    calibration.excursion_limit_mm = 0.0;
    const Drive drive = tone(calibration, 9.0, 0.5, 0.0);
    CHECK(drive.travel.motions.empty());
    CHECK(drive.largest_level == 1.0);
    CHECK(level_within_travel({10.0, 10.0}, drive.travel, 0.0) == 1.0);
}

TEST_CASE("travel: a drive's motion is that of its acceleration, integrated twice") {
    constexpr double kStep = 1e-4;
    for (const bool loop : {false, true}) {
        for (const double f_hz : {30.0, 60.0, 200.0}) {
            std::vector<double> g;
            for (int n = 0; n < 10'000; ++n) g.push_back(std::cos(kTau * f_hz * n * kStep));
            const Travel travel = travel_of(g, 1.0 / kStep, 5.0, 1.0, loop);
            double most_mm = 0.0;
            for (std::size_t k = 4000; k < travel.motions.size(); ++k) {
                most_mm = std::max(most_mm, std::abs(travel.motions[k].x_mm));
            }
            CHECK(std::abs(most_mm / (9806.65 / std::pow(kTau * f_hz, 2.0)) - 1.0) < 0.01);
        }
    }
}

}  // namespace travel_test
