#include "model/signal/alignment.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/support/temporary_folder.h"

namespace alignment_test {

using namespace tact;

namespace {

Waveform burst(double amplitude_g) {
    Waveform waveform{10'000.0, std::vector<double>(2000, 0.0)};
    for (std::size_t n = 300; n < 1500; ++n) {
        waveform.samples_g[n] =
            amplitude_g * std::sin(2.0 * std::numbers::pi * 0.015 * static_cast<double>(n));
    }
    return waveform;
}

}  // namespace

TEST_CASE("alignment: a recording far from its pattern's strength is said, whichever its sign") {
    const Waveform intended = burst(0.8);
    for (const double factor : {0.41, -0.41, 2.5}) {
        const Alignment alignment = aligned(burst(0.8 * factor), intended);
        CHECK(std::abs(alignment.gain_db - 20.0 * std::log10(std::abs(factor))) <= 1e-9);
        REQUIRE(remarks_on(alignment).size() == 1);
        CHECK(contains(remarks_on(alignment)[0],
                       factor > 1.0 ? "8.0 dB stronger than its pattern" : "7.7 dB weaker than"));
    }
    for (const double factor : {0.72, 1.0, 1.4}) {  // within 3 dB
        CHECK(remarks_on(aligned(burst(0.8 * factor), intended)).empty());
    }
    // Of something else there is no gain to speak of.
    CHECK(remarks_on(aligned({10'000.0, std::vector<double>(2000, 0.0)}, intended)).size() == 1);
}

}  // namespace alignment_test
