#include "model/pattern/same_vibration.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

namespace same_vibration_test {

using namespace tact;

namespace {

Pattern two_carriers() {
    Pattern pattern;
    pattern.carriers = {{70.0, 0.4, 0.0}, {150.0, 0.6, 0.5}};
    pattern.modulation = {ModulationKind::am, 4.0, 0.5};
    pattern.rhythm = {"x=--", 0.1};
    return pattern;
}

Pattern changed(const std::function<void(Pattern&)>& change) {
    Pattern pattern = two_carriers();
    change(pattern);
    return pattern;
}

double largest_difference_g(const Pattern& a, const Pattern& b) {
    const Waveform x = render(a);
    const Waveform y = render(b);
    REQUIRE(x.samples_g.size() == y.samples_g.size());
    double most_g = 0.0;
    for (std::size_t n = 0; n < x.samples_g.size(); ++n) {
        most_g = std::max(most_g, std::abs(x.samples_g[n] - y.samples_g[n]));
    }
    return most_g;
}

}  // namespace

TEST_CASE("same vibration: other words for the same samples are the same") {
    const Pattern base = two_carriers();
    const Pattern same[] = {
        changed([](Pattern& p) { std::swap(p.carriers[0], p.carriers[1]); }),
        changed([](Pattern& p) {
            p.carriers.push_back({300.0, 0.0, 0.0});
        }),
        changed([](Pattern& p) {
            p.amplitude_g = 2.0;
            for (Carrier& carrier : p.carriers) carrier.weight /= 2.0;
        }),
        changed([](Pattern& p) {
            p.carriers.push_back({70.0, 0.0, 1.0});
        }),
        changed([](Pattern& p) { p.carriers[0].weight = 0.1 + 0.1 + 0.1 + 0.1; }),
        changed([](Pattern& p) { p.rhythm.text = "x=--x=--"; }),
        changed([](Pattern& p) { p.rhythm.text = "xx--"; }),  // without ramps
        changed([](Pattern& p) {
            p.rhythm = {"x-", 0.2};
        }),
        changed([](Pattern& p) { p.rhythm.text = "x=--x=--x=-xxxx"; }),  // past the end
    };
    for (const Pattern& other : same) {
        CHECK(essence(other) == essence(base));
        CHECK(largest_difference_g(other, base) < 1e-12);
    }
}

TEST_CASE("same vibration: what is not felt does not count") {
    Pattern a;
    Pattern b;
    b.modulation = {ModulationKind::am, 0.0, 0.3};
    b.rhythm = {"x===", 0.125};
    CHECK(essence(a) == essence(b));
    b.attack_s = 0.01;  // now the notes of b begin again
    CHECK(essence(a) != essence(b));
    a.amplitude_g = 0.0;
    b = Pattern{};
    b.rhythm.text = "--";
    CHECK(essence(a) == essence(b));  // both silent
}

TEST_CASE("same vibration: every audible change makes another one") {
    const Pattern base = two_carriers();
    const Pattern others[] = {
        changed([](Pattern& p) { p.amplitude_g = 1.001; }),
        changed([](Pattern& p) { p.carriers[0].frequency_hz = 70.01; }),
        changed([](Pattern& p) { p.carriers[1].phase_rad = 0.6; }),
        changed([](Pattern& p) { std::swap(p.carriers[0].weight, p.carriers[1].weight); }),
        changed([](Pattern& p) { p.modulation.kind = ModulationKind::product; }),
        changed([](Pattern& p) { p.modulation.depth = 0.6; }),
        changed([](Pattern& p) { p.rhythm.text = "x---"; }),
        changed([](Pattern& p) { p.rhythm.unit_s = 0.11; }),
        changed([](Pattern& p) { p.attack_s = 0.01; }),
        changed([](Pattern& p) { p.release_s = 0.01; }),
        changed([](Pattern& p) { p.duration_s = 0.9; }),
    };
    SeenVibrations seen;
    CHECK(seen.add(base));
    for (const Pattern& other : others) CHECK(seen.add(other));
    for (const Pattern& other : others) CHECK_FALSE(seen.add(other));
}

TEST_CASE("same vibration: drawn in other words it is the same, as its samples are") {
    const auto sweep = [](Pattern& p) { p.frequency_curve = {{0.0, 50.0}, {1.0, 200.0}}; };
    const std::pair<Pattern, Pattern> same[] = {
        {changed([](Pattern& p) {
             p.amplitude_curve = {{0.0, 1.0}, {0.4, 1.0}};
         }),
         two_carriers()},
        {changed([](Pattern& p) {
             p.amplitude_curve = {{0.2, 0.5}};
             p.amplitude_g = 2.0;
         }),
         two_carriers()},
        {changed([](Pattern& p) {
             p.frequency_curve = {{0.0, 70.0}, {0.9, 70.0}};
         }),
         two_carriers()},
        {changed(sweep), changed([&](Pattern& p) {
             sweep(p);
             p.carriers[0].frequency_hz *= 2.0;  // only their ratio counts
             p.carriers[1].frequency_hz *= 2.0;
         })},
        {changed([](Pattern& p) {
             p.transients = {{0.1}, {0.5}};
         }),
         changed([](Pattern& p) {
             p.transients = {{0.5}, {0.1}, {0.2, 0.0}, {1.0}};  // of 0 g, and at the end
         })},
    };
    for (const auto& [a, b] : same) {
        CHECK(essence(a) == essence(b));
        CHECK(largest_difference_g(a, b) < 1e-12);
    }
}

TEST_CASE("same vibration: every change of what is drawn makes another one") {
    const auto drawn = [](const std::function<void(Pattern&)>& change) {
        return changed([&](Pattern& p) {
            p.amplitude_curve = {{0.0, 0.5}, {1.0, 1.0}};
            p.frequency_curve = {{0.0, 50.0}, {1.0, 200.0}};
            p.transients = {{0.1}};
            change(p);
        });
    };
    const Pattern all[] = {
        two_carriers(),
        drawn([](Pattern&) {}),
        drawn([](Pattern& p) { p.amplitude_curve.clear(); }),
        drawn([](Pattern& p) { p.amplitude_curve[0].value = 0.51; }),
        drawn([](Pattern& p) { p.amplitude_curve[0].time_s = 0.01; }),
        drawn([](Pattern& p) { p.frequency_curve.clear(); }),
        drawn([](Pattern& p) { p.frequency_curve[1].frequency_hz = 201.0; }),
        drawn([](Pattern& p) { std::swap(p.carriers[0], p.carriers[1]); }),
        drawn([](Pattern& p) { p.transients.clear(); }),
        drawn([](Pattern& p) { p.transients[0].shape = TransientShape::square; }),
        drawn([](Pattern& p) { p.transients[0].duration_s = 0.03; }),
        drawn([](Pattern& p) { p.transients.push_back({0.2}); }),
        // Silent but for the transient.
        drawn([](Pattern& p) { p.amplitude_g = 0.0; }),
        changed([](Pattern& p) { p.amplitude_g = 0.0; }),
    };
    SeenVibrations seen;
    for (const Pattern& one : all) CHECK(seen.add(one));
    for (const Pattern& one : all) CHECK_FALSE(seen.add(one));
}

}  // namespace same_vibration_test
