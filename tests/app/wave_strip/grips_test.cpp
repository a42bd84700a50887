// Grips of the wave strip, and the pattern after a drag.

#include "app/wave_strip/wave_strip.h"

#include "model/common/random.h"
#include "model/pattern/drawn_fault.h"
#include "tests/support/program.h"

namespace grips_test {

using namespace tact;

namespace {

struct Strip {
    Program program{short_patterns(1)};  // for its fonts
    Pattern pattern;

    StripScale scale() const {
        return strip_scale(pattern, 0.0, {{0, 0}, {500, 160}}, program.app.ui.theme,
                           {0.0, 1.06 * pattern.duration_s});
    }
    ImVec2 at_g(double t_s, double g) const {
        const StripScale s = scale();
        return {to_pixel(s.amplitude.x, t_s), to_pixel(s.amplitude.y, g)};
    }
    ImVec2 at_hz(double t_s, double hz) const {
        const StripScale s = scale();
        return {to_pixel(s.frequency.x, t_s), to_pixel(s.frequency.y, hz)};
    }
    Pattern drag(const Grip& grip, ImVec2 from, ImVec2 to, bool free = true) const {
        return dragged(pattern, grip, scale(), {from, to, false, free});
    }
};

}  // namespace

TEST_CASE("grips: the amplitude line is taken anywhere along it, and goes where the mouse goes") {
    Strip strip;
    strip.pattern.amplitude_g = 1.0;
    for (const double t_s : {0.2, 0.5, 0.9}) {
        const ImVec2 from = strip.at_g(t_s, 1.0);
        CHECK(grip_at(strip.pattern, strip.scale(), from, 6.0F) == Grip{GripKind::level, 0});
        const Pattern lower = strip.drag({GripKind::level, 0}, from, strip.at_g(t_s, 0.4));
        CHECK(lower.amplitude_g == doctest::Approx(0.4).epsilon(1e-4));
    }
    CHECK(!grip_at(strip.pattern, strip.scale(), strip.at_g(0.5, 0.5), 6.0F));
}

TEST_CASE("grips: a point added to a line leaves the pattern's wave as it is") {
    Strip strip;
    strip.pattern.amplitude_g = 0.8;
    strip.pattern.carriers[0].frequency_hz = 180.0;
    const Waveform before = render(strip.pattern);
    Pattern changed = strip.pattern;
    const auto point = add_point(changed, GripKind::level, 0.5);
    REQUIRE(point);
    CHECK(*point == Grip{GripKind::amplitude_point, 1});
    CHECK(changed.amplitude_curve.size() == 3);
    CHECK(render(changed) == before);
    const auto other = add_point(changed, GripKind::frequency, 0.5);
    REQUIRE(other);
    CHECK(*other == Grip{GripKind::frequency_point, 1});
    const Waveform after = render(changed);
    double most = 0.0;
    for (std::size_t n = 0; n < before.samples_g.size(); ++n) {
        most = std::max(most, std::abs(after.samples_g[n] - before.samples_g[n]));
    }
    CHECK(most < 1e-9);
}

TEST_CASE("grips: a point goes to where it is dragged, between its neighbours") {
    Strip strip;
    strip.pattern.amplitude_g = 1.0;
    strip.pattern.amplitude_curve = {{0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}};
    const ImVec2 from = strip.at_g(0.5, 1.0);
    const Grip grip{GripKind::amplitude_point, 1};
    CHECK(grip_at(strip.pattern, strip.scale(), from, 6.0F) == grip);
    const AmplitudePoint to = strip.drag(grip, from, strip.at_g(0.3, 0.25)).amplitude_curve[1];
    CHECK(to.time_s == doctest::Approx(0.3).epsilon(1e-4));
    CHECK(to.value == doctest::Approx(0.25).epsilon(1e-4));
    const AmplitudePoint far = strip.drag(grip, from, strip.at_g(2.0, 5.0)).amplitude_curve[1];
    CHECK(far.time_s == 1.0);
    CHECK(far.value == 1.0);
}

TEST_CASE("grips: Shift keeps to the axis along which a point went further") {
    Strip strip;
    strip.pattern.amplitude_g = 1.0;
    strip.pattern.amplitude_curve = {{0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}};
    const ImVec2 from = strip.at_g(0.5, 1.0);
    const auto point = [&](ImVec2 to) {
        return dragged(strip.pattern, {GripKind::amplitude_point, 1}, strip.scale(),
                       {from, to, true, true})
            .amplitude_curve[1];
    };
    CHECK(point(from + ImVec2{50, 10}).value == 1.0);
    CHECK(point(from + ImVec2{50, 10}).time_s > 0.55);
    CHECK(point(from + ImVec2{10, 50}).time_s == 0.5);
    CHECK(point(from + ImVec2{10, 50}).value < 0.8);
}

TEST_CASE("grips: a whole frequency curve is dragged in proportion") {
    Strip strip;
    strip.pattern.frequency_curve = {{0.0, 80.0}, {1.0, 240.0}};
    const Pattern higher =
        strip.drag({GripKind::frequency, 0}, strip.at_hz(0.0, 80.0), strip.at_hz(0.0, 100.0));
    CHECK(higher.frequency_curve[0].frequency_hz == doctest::Approx(100.0).epsilon(1e-4));
    CHECK(higher.frequency_curve[1].frequency_hz == doctest::Approx(300.0).epsilon(1e-4));
}

TEST_CASE("grips: times keep to 5 ms and peaks to 0.01 g, unless Alt frees them") {
    Strip strip;
    strip.pattern.transients = {{0.1, 1.0, 150.0, 0.02, TransientShape::sine}};
    const ImVec2 from = strip.at_g(0.1, 1.0);
    const Grip grip{GripKind::transient, 0};
    CHECK(grip_at(strip.pattern, strip.scale(), from, 6.0F) == grip);
    const Transient kept = strip.drag(grip, from, strip.at_g(0.4017, 0.4567), false).transients[0];
    CHECK(kept.time_s == doctest::Approx(0.4));
    CHECK(kept.amplitude_g == doctest::Approx(0.46));
    const Transient free = strip.drag(grip, from, strip.at_g(0.4017, 0.4567), true).transients[0];
    CHECK(free.time_s == doctest::Approx(0.4017).epsilon(1e-4));
    CHECK(free.amplitude_g == doctest::Approx(0.4567).epsilon(1e-4));
}

TEST_CASE("grips: ramps and the end follow the mouse") {
    Strip strip;
    strip.pattern.attack_s = 0.1;
    strip.pattern.release_s = 0.2;
    const double g = strip.pattern.amplitude_g;
    const auto dragged_by = [&](GripKind kind, double from_s, double to_s) {
        CHECK(grip_at(strip.pattern, strip.scale(), strip.at_g(from_s, g), 3.0F)->kind == kind);
        return strip.drag({kind, 0}, strip.at_g(from_s, g), strip.at_g(to_s, g));
    };
    CHECK(dragged_by(GripKind::attack, 0.1, 0.25).attack_s == doctest::Approx(0.25).epsilon(1e-4));
    CHECK(dragged_by(GripKind::release, 0.8, 0.6).release_s == doctest::Approx(0.4).epsilon(1e-4));
    CHECK(strip.drag({GripKind::end, 0}, strip.at_g(1.0, 0.2), strip.at_g(0.7, 0.2)).duration_s ==
          doctest::Approx(0.7).epsilon(1e-4));
}

TEST_CASE("grips: a note is taken by its edges and in its middle, and keeps to the rhythm's grid") {
    Strip strip;
    strip.pattern.rhythm = {"x=--x=--", 0.125};
    const auto over = [&](double t_s) {
        return grip_at(strip.pattern, strip.scale(), strip.at_g(t_s, 0.02), 6.0F);
    };
    CHECK(over(0.5) == Grip{GripKind::note_start, 1});
    CHECK(over(0.62) == Grip{GripKind::note, 1});
    CHECK(over(0.75) == Grip{GripKind::note_end, 1});
    CHECK(!over(0.4));
    const auto text_after = [&](Grip grip, double from_s, double to_s) {
        return strip.drag(grip, strip.at_g(from_s, 0.02), strip.at_g(to_s, 0.3), false).rhythm.text;
    };
    CHECK(text_after({GripKind::note_end, 1}, 0.75, 0.9) == "x=--x==-");
    CHECK(text_after({GripKind::note_start, 1}, 0.5, 0.39) == "x=-x==--");
    CHECK(text_after({GripKind::note, 0}, 0.1, 0.2) == "-x=-x=--");
    CHECK(text_after({GripKind::note, 0}, 0.1, 0.15) == "x=--x=--");
}

TEST_CASE("grips: a note of a repetition moves those of all, and Alt frees it to quarters") {
    Strip strip;
    strip.pattern.rhythm = {"x-", 0.25};
    const auto after = [&](double to_s, bool free) {
        return strip
            .drag({GripKind::note_end, 1}, strip.at_g(0.75, 0.02), strip.at_g(to_s, 0.02), free)
            .rhythm;
    };
    CHECK(after(0.99, false) == Rhythm{"x=", 0.25});
    CHECK(after(0.875, true) == Rhythm{"x==-", 0.125, {}, {8, 0}});
    CHECK(after(0.82, true) == Rhythm{"x====---", 0.0625, {}, {16, 0}});
    CHECK(after(0.76, true) == Rhythm{"x-", 0.25});
}

TEST_CASE("grips: points and transients are gone through in time, round from end to end") {
    Pattern pattern;
    CHECK(!next_single(pattern, std::nullopt, 1));
    pattern.amplitude_curve = {{0.0, 0.0}, {0.5, 1.0}};
    pattern.transients = {{0.7, 1.0}, {0.2, 1.0}};
    const std::vector<Grip> order{{GripKind::amplitude_point, 0},
                                  {GripKind::transient, 1},
                                  {GripKind::amplitude_point, 1},
                                  {GripKind::transient, 0}};
    CHECK(next_single(pattern, std::nullopt, 1) == order.front());
    CHECK(next_single(pattern, std::nullopt, -1) == order.back());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Grip& next = order[(k + 1) % order.size()];
        CHECK(next_single(pattern, order[k], 1) == next);
        CHECK(next_single(pattern, next, -1) == order[k]);
    }
}

TEST_CASE("grips: whatever is dragged wherever leaves a pattern that can be saved") {
    RandomStream random{11};
    const auto place = [&] {
        return ImVec2{static_cast<float>(700.0 * next_even(random) - 100.0),
                      static_cast<float>(400.0 * next_even(random) - 100.0)};
    };
    Strip strip;
    for (int run = 0; run < 300; ++run) {
        strip.pattern = {};
        for (int step = 0; step < 8; ++step) {
            Pattern& pattern = strip.pattern;
            const StripScale scale = strip.scale();
            const double choice = next_even(random);
            if (choice < 0.2) (void)add_point(pattern, GripKind::level, next_even(random));
            if (choice > 0.2 && choice < 0.4) {
                (void)add_point(pattern, GripKind::frequency, next_even(random));
            }
            if (choice > 0.5 && choice < 0.6) pattern.rhythm = {"x=-x--", 0.05};
            if (choice > 0.4 && choice < 0.5)
                (void)add_transient(pattern, next_even(random), 60.0 * next_even(random));
            const auto grip = grip_at(pattern, scale, place(), 80.0F);
            if (!grip) continue;
            pattern = dragged(pattern, *grip, scale,
                              {place(), place(), next_even(random) < 0.5, next_even(random) < 0.5});
            if (next_even(random) < 0.1) remove(pattern, *grip);
            const auto fault = drawn_fault(pattern);
            REQUIRE_MESSAGE(!fault, sentence(*fault));
            REQUIRE(clamped(pattern) == pattern);
        }
    }
}

}  // namespace grips_test
