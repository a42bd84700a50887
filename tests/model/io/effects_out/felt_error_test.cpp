// Points where they are felt: laws of the measure, and of curves thinned by it.
#include "model/io/effects_out/shares.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/io/effects_out/knots.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "model/pattern/curves.h"
#include "model/physiology/mechanoreceptor.h"

namespace felt_error_test {

using namespace tact;

namespace {

constexpr double kHz = 150.0;

// Peak acceleration at which the best receptor begins to feel.
double threshold_g(double hz) {
    double least_um = 1e9;
    for (const Receptor receptor : kReceptors) {
        const Curve& curve = default_tables().threshold[index_of(receptor)];
        least_um = std::min(least_um, std::pow(10.0, at(curve, hz)));
    }
    return least_um / displacement_um(1.0, hz);
}

double above_threshold_g(double db) { return threshold_g(kHz) * std::pow(10.0, db / 20.0); }

std::vector<double> heights(const AmplitudeCurve& curve) {
    std::vector<double> all;
    for (const AmplitudePoint& point : curve) all.push_back(point.value);
    return all;
}

std::vector<double> times(const AmplitudeCurve& curve) {
    std::vector<double> all;
    for (const AmplitudePoint& point : curve) all.push_back(point.time_s);
    return all;
}

AmplitudeCurve random_curve(std::mt19937& random, std::size_t points) {
    // From 10 dB below threshold to 50 above: what designers draw on a scale of feeling.
    std::uniform_real_distribution<double> level_db(-10.0, 50.0);
    AmplitudeCurve curve;
    for (std::size_t k = 0; k < points; ++k) {
        curve.push_back({0.03 * static_cast<double>(k), above_threshold_g(level_db(random))});
    }
    return curve;
}

// The error of lines through the kept points, at the points of the curve.
double largest_db(const AmplitudeCurve& curve, const std::vector<std::size_t>& kept) {
    double largest = 0.0;
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
        const AmplitudePoint& a = curve[kept[k]];
        const AmplitudePoint& b = curve[kept[k + 1]];
        for (std::size_t n = kept[k]; n <= kept[k + 1]; ++n) {
            const double share = (curve[n].time_s - a.time_s) / (b.time_s - a.time_s);
            const double line_g = std::lerp(a.value, b.value, share);
            largest = std::max(largest, felt_error_db({curve[n].value, kHz}, {line_g, kHz}));
        }
    }
    return largest;
}

KnotRules rules_of(std::size_t most) {
    KnotRules rules;
    rules.most = most;
    rules.least_gap_s = 0.001;
    rules.felt = [](const Knot& knot) { return FeltTone{knot.amplitude, knot.frequency}; };
    return rules;
}

}  // namespace

TEST_CASE("felt error: nothing below threshold, levels above it") {
    CHECK(felt_error_db({0.9 * threshold_g(kHz), kHz}, {0.0, kHz}) == 0.0);
    CHECK(felt_error_db({0.0, kHz}, {0.5 * threshold_g(kHz), 30.0}) == 0.0);
    CHECK(felt_error_db({above_threshold_g(12.0), kHz}, {0.0, kHz}) == doctest::Approx(12.0));
    // The same ratio is the same error at any level.
    for (const double db : {10.0, 30.0, 50.0}) {
        const double a_g = above_threshold_g(db);
        CHECK(felt_error_db({a_g, kHz}, {2.0 * a_g, kHz}) ==
              doctest::Approx(20.0 * std::log10(2.0)));
        CHECK(felt_error_db({a_g, kHz}, {2.0 * a_g, kHz}) ==
              felt_error_db({2.0 * a_g, kHz}, {a_g, kHz}));
    }
    CHECK(felt_error_db({0.3, kHz}, {0.3, kHz}) == 0.0);
}

TEST_CASE("felt error: a frequency counts by its ratio where it is felt") {
    // Level falls by more than the ratio where the skin is less sensitive.
    CHECK(felt_error_db({1.0, 100.0}, {1.0, 120.0}) >= 20.0 * std::log10(1.2) * 0.999);
    CHECK(felt_error_db({1e-9, 100.0}, {1e-9, 200.0}) == 0.0);
}

TEST_CASE(
    "felt error: thinned by it, no more than the limit, ends kept, and less dB off than by g") {
    std::mt19937 random(5);
    double felt_db = 0.0;
    double plain_db = 0.0;
    constexpr int kCurves = 100;
    for (int k = 0; k < kCurves; ++k) {
        const AmplitudeCurve curve = random_curve(random, 40);
        const auto weight = [&](std::size_t place, double line_g) {
            return felt_error_db({curve[place].value, kHz}, {line_g, kHz});
        };
        for (const std::size_t most : {2U, 5U, 16U, 60U}) {
            const Thinning felt = thinned(times(curve), heights(curve), most, 0.0, weight);
            const Thinning plain = thinned(times(curve), heights(curve), most, 0.0);
            CHECK(felt.kept.size() <= most);
            CHECK(felt.kept.front() == 0);
            CHECK(felt.kept.back() == curve.size() - 1);
            CHECK(felt.largest_weight == doctest::Approx(largest_db(curve, felt.kept)));
            if (most == 60) CHECK(felt.kept.size() == curve.size());
            if (most != 16) continue;
            felt_db += felt.largest_weight / kCurves;
            plain_db += largest_db(curve, plain.kept) / kCurves;
        }
    }
    MESSAGE("16 of 40 points: " << felt_db << " dB by what is felt, " << plain_db << " dB by g");
    CHECK(felt_db < plain_db);
}

TEST_CASE("felt error: what nobody feels gets its points last, and gets them where there is room") {
    // Far below threshold a zigzag; behind it a faint one that is felt, smaller in g by itself.
    AmplitudeCurve curve;
    const double unfelt_hz = 2.0;
    const double unfelt_g = 0.5 * threshold_g(unfelt_hz);
    const double felt_g = above_threshold_g(6.0);
    REQUIRE(unfelt_g > 0.0);
    for (int k = 0; k < 20; ++k) curve.push_back({0.01 * k, k % 2 == 0 ? 0.0 : unfelt_g});
    for (int k = 20; k < 30; ++k) curve.push_back({0.01 * k, k % 2 == 0 ? 0.0 : felt_g});
    const AmplitudeCurve hz{{0.0, unfelt_hz}, {0.195, unfelt_hz}, {0.196, kHz}, {0.29, kHz}};
    const FittedKnots few = fitted_knots(curve, hz, 0.29, rules_of(12));
    CHECK(few.knots.size() == 12);
    for (const Knot& knot : few.knots) {
        const bool inside = knot.time_s > 0.001 && knot.time_s < 0.185;
        CHECK_FALSE(inside);
    }
    const FittedKnots all = fitted_knots(curve, hz, 0.29, rules_of(60));
    for (const AmplitudePoint& point : curve) {
        CHECK(std::ranges::any_of(all.knots, [&](const Knot& knot) {
            return std::abs(knot.time_s - point.time_s) < 1e-9 &&
                   std::abs(knot.amplitude - point.value) < 1e-12;
        }));
    }
}

TEST_CASE("felt error: it is said that points are thinned, and nothing where none are") {
    std::vector<std::string> coarse;
    std::mt19937 random(6);
    const AmplitudeCurve curve = random_curve(random, 37);
    const AmplitudeCurve hz{{0.0, kHz}};
    remark_fit(fitted_knots(curve, hz, curve.back().time_s, rules_of(16)), rules_of(16), coarse);
    CHECK(coarse == std::vector<std::string>{"37 points thinned to 16, at least 1 ms apart"});
    remark_fit(fitted_knots(curve, hz, curve.back().time_s, rules_of(60)), rules_of(60), coarse);
    CHECK(coarse.size() == 1);
}

TEST_CASE("felt error: a player that begins in silence has amplitude 0 at 0 s, and no less later") {
    KnotRules rules = rules_of(16);
    rules.least_gap_s = 0.02;
    rules.from_silence = true;
    const AmplitudeCurve flat{{0.0, 0.8}, {0.3, 0.8}};
    const AmplitudeCurve hz{{0.0, kHz}};
    const FittedKnots fit = fitted_knots(flat, hz, 0.3, rules);
    CHECK(fit.knots.front() == Knot{0.0, 0.0, kHz});
    CHECK(fit.knots[1] == Knot{0.02, 0.8, kHz});
    // What is over before it can be loud is played when it can.
    const AmplitudeCurve pulse{{0.0, 0.8}, {0.012, 0.8}, {0.012, 0.0}, {0.1, 0.0}};
    const FittedKnots late = fitted_knots(pulse, hz, 0.1, rules);
    CHECK(late.knots[1] == Knot{0.02, 0.8, kHz});
    CHECK(late.knots.back().amplitude == 0.0);
    const auto written =
        write_effect(TargetFormat::android_xml, Pattern{}, {"x", bundled_actuator("android")});
    const auto back = read_effects(written.text, "x.xml");
    REQUIRE(back);
    CHECK(envelope_g(back->effects.front().pattern, 0.0) == 0.0);
}

TEST_CASE(
    "felt error: both curves of a format with a limit keep to it, those that are felt first") {
    std::mt19937 random(9);
    ActuatorMap map;
    Shares shares;
    shares.duration_s = 2.0;
    std::uniform_real_distribution<double> any(0.0, 1.0);
    for (int k = 0; k <= 200; ++k) {
        const double t_s = 0.01 * k;
        // Silent in the second half, where the frequency sweeps most.
        shares.amplitude.push_back({t_s, k < 100 ? any(random) : 0.0});
        shares.frequency.push_back({t_s, k < 100 ? 0.5 + 0.1 * any(random) : any(random)});
    }
    std::vector<std::string> remarks;
    Shares thin = shares;
    thin_shares(thin, 60, map, remarks);
    CHECK(thin.amplitude.size() == 60);
    CHECK(thin.frequency.size() == 60);
    REQUIRE(remarks.size() == 2);
    CHECK(remarks[0] == "201 points of amplitude thinned to 60");
    CHECK(remarks[1] == "201 points of frequency thinned to 60");
    CHECK(thin.frequency.front() == shares.frequency.front());
    CHECK(thin.frequency.back() == shares.frequency.back());
    const auto unfelt = std::ranges::count_if(
        thin.frequency, [](const AmplitudePoint& point) { return point.time_s > 1.02; });
    CHECK(unfelt <= 2);
    const Shares as_it_was = thin;
    thin_shares(thin, 60, map, remarks);
    CHECK(thin.amplitude == as_it_was.amplitude);
    CHECK(remarks.size() == 2);
}

TEST_CASE("felt error: Android's sixteen points go where a faint end is felt, not where g are") {
    // Loud wiggles of 1 dB, then a tail that is faint and felt: by g the tail is nothing.
    Pattern pattern;
    pattern.amplitude_g = 1.0;
    pattern.duration_s = 2.4;
    for (int k = 0; k < 30; ++k) {
        pattern.amplitude_curve.push_back({0.04 * k, k % 2 == 0 ? 0.9 : 1.0});
    }
    const double faint_g = above_threshold_g(20.0);
    for (int k = 30; k <= 60; k += 3) {
        pattern.amplitude_curve.push_back({0.04 * k, k % 2 == 0 ? faint_g : 0.0});
    }
    const auto written =
        write_effect(TargetFormat::android_xml, pattern, {"x", bundled_actuator("android")});
    const auto back = read_effects(written.text, "x.xml");
    REQUIRE(back);
    const auto& curve = back->effects.front().pattern.amplitude_curve;
    const auto late = std::ranges::count_if(
        curve, [](const AmplitudePoint& point) { return point.time_s > 1.25; });
    CHECK(late >= 8);
}

}  // namespace felt_error_test
