#include <cmath>
#include <limits>
#include <numbers>

#include "model/pattern/drawn_fault.h"
#include "model/pattern/pattern.h"
#include "tests/support/golden.h"

namespace drawn_test {

using namespace tact;

namespace {

constexpr long double kTurn = 2.0L * std::numbers::pi_v<long double>;

Pattern with_everything() {
    Pattern pattern;
    pattern.amplitude_g = 1.5;
    pattern.carriers = {{90.0, 0.7, 0.3}, {210.0, -0.4, 1.0}};
    pattern.modulation = {ModulationKind::am, 7.0, 0.5};
    pattern.rhythm = {"x=-x", 0.11};
    pattern.attack_s = 0.02;
    pattern.release_s = 0.03;
    return pattern;
}

double farthest_g(const Pattern& a, const Pattern& b) {
    return golden::worst_difference(render(a).samples_g, render(b).samples_g);
}

}  // namespace

TEST_CASE("drawn: a chirp of a minute has the phase of a chirp, however many points say it") {
    Pattern chirp;
    chirp.duration_s = 60.0;
    chirp.frequency_curve = {{0.0, 20.0}, {60.0, 500.0}};
    Pattern dotted = chirp;
    dotted.frequency_curve.clear();
    for (int k = 0; k < 500; ++k) {
        dotted.frequency_curve.push_back({k * 60.0 / 499.0, 20.0 + k * 480.0 / 499.0});
    }
    REQUIRE(!drawn_fault(dotted));
    const auto samples = render(chirp).samples_g;
    const auto dots = render(dotted).samples_g;
    long double farthest = 0.0L;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const long double t = n / 10'000.0L;
        const long double expected = std::sin(kTurn * (20.0L * t + 480.0L * t * t / 120.0L));
        farthest = std::max(farthest, std::abs(samples[n] - expected));
        farthest = std::max(farthest, std::abs(dots[n] - expected));
    }
    CHECK(static_cast<double>(farthest) <= 1e-9);
}

TEST_CASE("drawn: a frequency curve that says what the carrier says changes nothing but rounding") {
    Pattern drawn = with_everything();
    drawn.frequency_curve = {{0.0, 90.0}, {0.4, 90.0}, {1.0, 90.0}};
    CHECK(farthest_g(drawn, with_everything()) <= 1e-12);
}

TEST_CASE("drawn: the other carriers keep their ratio to the first one") {
    Pattern drawn = with_everything();
    drawn.frequency_curve = {{0.3, 30.0}};
    Pattern lower = with_everything();
    lower.carriers[0].frequency_hz = 30.0;
    lower.carriers[1].frequency_hz = 70.0;
    CHECK(farthest_g(drawn, lower) <= 1e-12);
}

TEST_CASE("drawn: a carrier that its ratio takes above half the rate is silent, not another") {
    Pattern drawn;
    drawn.carriers = {{100.0, 0.5, 0.0}, {1000.0, 0.5, 0.0}};
    drawn.frequency_curve = {{0.0, 600.0}};
    Pattern low;
    low.carriers = {{600.0, 0.5, 0.0}};
    CHECK(farthest_g(drawn, low) <= 1e-12);
}

TEST_CASE("drawn: an amplitude of 1 throughout gives the same bits as none") {
    Pattern drawn = with_everything();
    drawn.amplitude_curve = {{0.0, 1.0}, {0.37, 1.0}, {1.0, 1.0}};
    CHECK(render(drawn) == render(with_everything()));
}

TEST_CASE("drawn: the amplitude curve multiplies the carriers, and no transient") {
    Pattern drawn = with_everything();
    drawn.amplitude_curve = {{0.0, 0.0}, {0.5, 1.0}, {0.5, 0.25}};
    const auto plain = render(with_everything()).samples_g;
    const auto shaped = render(drawn).samples_g;
    for (std::size_t n = 0; n < plain.size(); n += 7) {
        const double t = static_cast<double>(n) / 10'000.0;
        CHECK(std::abs(shaped[n] - plain[n] * (t < 0.5 ? 2.0 * t : 0.25)) <= 1e-14);
    }
    Pattern burst;
    burst.amplitude_g = 0.0;
    burst.rhythm.text = "-";
    burst.amplitude_curve = {{0.0, 0.0}};
    burst.transients = {{0.25, 2.0, 80.0, 0.1, TransientShape::sine}};
    CHECK(peak_g(render(burst)) > 1.9);
}

TEST_CASE("drawn: a transient is cut at the pattern's end, and up to there it is the whole one's") {
    Pattern cut;
    cut.amplitude_g = 0.0;
    cut.duration_s = 0.1;
    cut.transients = {{0.07, 1.0, 150.0, 0.08, TransientShape::sine}};
    Pattern whole = cut;
    whole.duration_s = 0.2;
    const auto samples = render(cut).samples_g;
    const auto longer = render(whole).samples_g;
    REQUIRE(samples.size() == 1000);
    CHECK(std::equal(samples.begin(), samples.end(), longer.begin()));
    CHECK(peak_g({10'000.0, samples}) > 0.9);
    cut.transients[0].time_s = 0.1;
    CHECK(peak_g(render(cut)) == 0.0);
}

TEST_CASE("drawn: the outline of a pattern is what its samples reach") {
    Pattern pattern = with_everything();
    pattern.carriers = {{0.1, 1.0, std::numbers::pi / 2.0}};  // next to constant
    pattern.modulation = {};
    pattern.duration_s = 0.9;
    pattern.amplitude_curve = {{0.0, 0.2}, {0.5, 1.0}, {0.5, 0.4}, {0.9, 0.9}};
    const auto samples = render(pattern).samples_g;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double t = static_cast<double>(n) / 10'000.0;
        const double carrier = std::cos(2.0 * std::numbers::pi * 0.1 * t);
        CHECK(std::abs(envelope_g(pattern, t) * carrier - samples[n]) <= 1e-9);
    }
    CHECK(envelope_g(pattern, -0.001) == 0.0);
    CHECK(envelope_g(pattern, 0.9) == 0.0);
    CHECK(first_carrier_hz(pattern, 0.3) == 0.1);
    pattern.frequency_curve = {{0.0, 100.0}, {0.4, 300.0}};
    CHECK(first_carrier_hz(pattern, 0.1) == 150.0);
}

TEST_CASE("drawn: shorter, a pattern keeps what is within it; longer, all; and stays valid") {
    Pattern pattern;
    pattern.amplitude_curve = {{0.0, 0.0}, {1.0, 1.0}};
    pattern.frequency_curve = {{0.1, 100.0}, {0.9, 200.0}};
    pattern.transients = {{0.1}, {0.9}};
    const Pattern half = with_duration(pattern, 0.5);
    CHECK(half.amplitude_curve == AmplitudeCurve{{0.0, 0.0}, {0.5, 0.5}});
    CHECK(half.frequency_curve == FrequencyCurve{{0.1, 100.0}, {0.5, 150.0}});
    CHECK(half.transients.size() == 1);
    CHECK(!drawn_fault(half));
    const auto whole = render(pattern).samples_g;
    const auto part = render(half).samples_g;
    CHECK(golden::worst_difference(part, {whole.begin(), whole.begin() + 5000}) <= 1e-12);
    CHECK(with_duration(pattern, 2.0).amplitude_curve == pattern.amplitude_curve);
    // What an editor of numbers does.
    Pattern edited = pattern;
    edited.duration_s = 0.5;
    CHECK(clamped(edited) == half);
    CHECK(clamped(pattern) == pattern);
}

TEST_CASE("drawn: clamping gives curves without fault, whatever they were") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Pattern wild;
    wild.amplitude_curve = {{0.5, 7.0}, {0.2, nan}, {0.2, 0.5}, {nan, -1.0}, {99.0, 0.1}};
    wild.frequency_curve.assign(200'000, {0.5, 1e9});
    wild.transients.assign(20'000, {nan, nan, nan, nan, TransientShape::square});
    REQUIRE(drawn_fault(wild));
    const Pattern tame = clamped(wild);
    CHECK(!drawn_fault(tame));
    CHECK(tame.amplitude_curve.front() == AmplitudePoint{0.5, 1.0});
    CHECK(tame.transients.size() == limits::kMaxTransients);
    CHECK(clamped(tame) == tame);
}

}  // namespace drawn_test
