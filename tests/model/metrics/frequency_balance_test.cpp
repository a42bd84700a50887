// The balance of low and high frequencies, against what can be worked out by hand.
#include "model/metrics/frequency_balance.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/pattern/pattern.h"

namespace frequency_balance_test {

using namespace tact;

namespace {

double balance_db(std::vector<Carrier> carriers, double amplitude_g = 1.0) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers = std::move(carriers);
    const Waveform wave = render(pattern);
    return frequency_balance_db(amplitude_spectrum(without_mean(wave.samples_g), wave.rate_hz));
}

}  // namespace

TEST_CASE("balance: a single frequency is at 60 dB or at -60 dB, silence at 0") {
    CHECK(balance_db({{250.0, 1.0, 0.0}}) == doctest::Approx(60.0).epsilon(1e-6));
    CHECK(balance_db({{40.0, 1.0, 0.0}}) == doctest::Approx(-60.0).epsilon(1e-6));
    CHECK(balance_db({{100.0, 1.0, 0.0}}) == doctest::Approx(60.0).epsilon(1e-6));
    CHECK(balance_db({{40.0, 0.0, 0.0}}) == 0.0);
}

TEST_CASE("balance: of two carriers it is the ratio of their powers, whatever the strength") {
    for (const double g : {0.01, 1.0, 7.0}) {
        CHECK(balance_db({{40.0, 1.0, 0.3}, {250.0, 1.0, 1.0}}, g) == doctest::Approx(0.0));
        CHECK(balance_db({{40.0, 1.0, 0.3}, {250.0, 2.0, 1.0}}, g) ==
              doctest::Approx(20.0 * std::log10(2.0)).epsilon(1e-4));
    }
    // Below 10 Hz nothing counts.
    CHECK(balance_db({{4.0, 5.0, 0.0}, {40.0, 1.0, 0.0}, {250.0, 1.0, 0.0}}) ==
          doctest::Approx(0.0).epsilon(1e-6));
}

}  // namespace frequency_balance_test
