// An accent is felt beside what sounds under it, whatever the phase in which they meet.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/pattern/accents.h"
#include "model/pattern/pattern.h"

namespace accents_test {

using namespace tact;

namespace {

double energy(const Waveform& waveform, double from_s, double to_s) {
    double sum = 0.0;
    for (auto n = static_cast<std::size_t>(from_s * 1e4); n < waveform.samples_g.size(); ++n) {
        if (static_cast<double>(n) >= to_s * 1e4) break;
        sum += waveform.samples_g[n] * waveform.samples_g[n];
    }
    return sum;
}

Pattern sustained(double hz) {
    Pattern pattern;
    pattern.carriers = {{hz, 1.0, 0.0}};
    pattern.duration_s = 0.5;
    return pattern;
}

double energy_with(Pattern pattern, const std::vector<Transient>& accents) {
    pattern.transients = accents;
    return energy(render(pattern), 0.0, pattern.duration_s);
}

// Where the pattern is silent, its waveform is the plain sum, in whichever order they are listed.
void check_added(Pattern pattern, const Transient& first, const Transient& second) {
    const auto plain = render(pattern).samples_g;
    for (const auto& listed : {std::vector{first, second}, std::vector{second, first}}) {
        pattern.transients = listed;
        const auto sum = render(pattern).samples_g;
        for (std::size_t n = 0; n < sum.size(); ++n) {
            const double t_s = static_cast<double>(n) / 1e4;
            CHECK(sum[n] == plain[n] + transient_g(first, t_s - first.time_s) +
                                transient_g(second, t_s - second.time_s));
        }
    }
}

}  // namespace

TEST_CASE("accents: their energy is added to what sounds under them, wherever they begin") {
    for (const TransientShape shape : {TransientShape::sine, TransientShape::square}) {
        for (const double hz : {70.0, 149.6, 230.0}) {
            for (const double level_g : {0.05, 0.8, 2.0}) {
                const Pattern under = sustained(149.6);
                Pattern silent = under;
                silent.amplitude_g = 0.0;
                for (double t_s = 0.2; t_s < 0.208; t_s += 0.0007) {
                    CAPTURE(hz);
                    CAPTURE(level_g);
                    CAPTURE(t_s);
                    const Transient accent{t_s, level_g, hz, 0.022, shape};
                    const double added = energy_with(under, {accent}) - energy_with(under, {});
                    const double alone = energy_with(silent, {accent});
                    CHECK(added > 0.5 * alone);
                    CHECK(added < 1.5 * alone);
                }
            }
        }
    }
}

TEST_CASE("accents: over modulated, swept and several carriers the level is never below theirs") {
    Pattern under = sustained(90.0);
    under.carriers.push_back({140.0, 0.7, 0.3});
    under.modulation = {ModulationKind::am, 20.0, 0.6};
    under.frequency_curve = {{0.0, 60.0}, {0.5, 200.0}};
    const Waveform plain = render(under);
    for (double t_s = 0.1; t_s < 0.4; t_s += 0.0113) {
        CAPTURE(t_s);
        Pattern with = under;
        with.transients = {{t_s, 0.6, 130.0, 0.03, TransientShape::sine}};
        CHECK(energy(render(with), t_s, t_s + 0.03) > energy(plain, t_s, t_s + 0.03));
    }
}

TEST_CASE("accents: over silence they begin at phase 0, and their order in the list is nothing") {
    Pattern pattern = sustained(150.0);
    pattern.rhythm = {"x-", 0.1};
    const Transient first{0.13, 1.0, 90.0, 0.022, TransientShape::sine};
    const Transient second{0.33, 2.0, 130.0, 0.022, TransientShape::square};
    check_added(pattern, first, second);
    Pattern close = pattern;
    close.transients = {{0.13, 1.0, 90.0, 0.022, TransientShape::sine},
                        {0.14, 1.0, 90.0, 0.022, TransientShape::sine}};
    const Waveform forward = render(close);
    std::ranges::reverse(close.transients);
    CHECK(render(close) == forward);
}

TEST_CASE("accents: of two that overlap over a vibration none takes the other's energy away") {
    Pattern under = sustained(150.0);
    under.amplitude_g = 0.4;
    const double plain = energy_with(under, {});
    const double one = energy_with(under, {{0.2, 1.0, 100.0, 0.022, TransientShape::sine}}) - plain;
    for (double t_s = 0.201; t_s < 0.222; t_s += 0.001) {
        CAPTURE(t_s);
        const double both = energy_with(under, {{0.2, 1.0, 100.0, 0.022, TransientShape::sine},
                                                {t_s, 1.0, 100.0, 0.022, TransientShape::sine}});
        CHECK(both - plain > 1.6 * one);
        CHECK(both - plain < 2.4 * one);
    }
}

TEST_CASE("accents: over silence they are added as they are, whether they overlap or not") {
    Pattern pattern = sustained(150.0);
    pattern.rhythm = {"x-", 0.1};
    const Transient first{0.13, 1.0, 90.0, 0.022, TransientShape::sine};
    const Transient second{0.141, 0.7, 130.0, 0.022, TransientShape::square};
    check_added(pattern, first, second);
}

TEST_CASE("accents: a note that ends in a tick's first samples leaves it as it is") {
    Pattern pattern = sustained(150.0);
    pattern.rhythm = {"x-", 0.1};
    const Transient tick{0.0995, 1.0, 90.0, 0.022, TransientShape::sine};
    const auto plain = render(pattern).samples_g;
    pattern.transients = {tick};
    const auto sum = render(pattern).samples_g;
    for (std::size_t n = 0; n < sum.size(); ++n) {
        CHECK(sum[n] == plain[n] + transient_g(tick, static_cast<double>(n) / 1e4 - 0.0995));
    }
}

TEST_CASE("accents: moved by up to 3 ms, the level over one changes by less than 2 dB") {
    for (const double accent_hz : {60.0, 140.0, 149.6, 185.0, 230.0}) {
        CAPTURE(accent_hz);
        const Pattern under = sustained(149.6);
        double least = 1e9;
        double most = 0.0;
        for (double t_s = 0.2; t_s < 0.208; t_s += 0.0005) {
            Pattern with = under;
            with.transients = {{t_s, 1.6, accent_hz, 0.022, TransientShape::sine}};
            const double over = energy(render(with), t_s, t_s + 0.022);
            CHECK(over > energy(render(under), t_s, t_s + 0.022));
            least = std::min(least, over);
            most = std::max(most, over);
        }
        CHECK(10.0 * std::log10(most / least) < 2.0);
    }
}

}  // namespace accents_test
