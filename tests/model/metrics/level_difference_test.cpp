#include "model/metrics/level_difference.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace level_difference_test {

using namespace tact;

TEST_CASE("level difference: half the amplitude is 6.02 dB, whatever else differs") {
    const auto strong = tone(70.0, kModelRateHz, 10'000).samples_g;
    const auto weak = tone(250.0, kModelRateHz, 10'000, 0.5).samples_g;
    CHECK(std::abs(level_db(strong) - 20.0 * std::log10(std::sqrt(0.5))) <= 1e-12);
    CHECK(std::abs(level_difference(strong, weak) - 20.0 * std::log10(2.0)) <= 1e-12);
    CHECK(level_difference(strong, weak) == level_difference(weak, strong));
}

TEST_CASE("level difference: a constant offset is silence, and silences are equal") {
    const std::vector<double> silence(100, 0.0);
    const std::vector<double> offset(100, 0.25);
    CHECK(level_db(silence) == -120.0);
    CHECK(level_difference(silence, offset) == 0.0);
    CHECK(level_difference({}, silence) == 0.0);
}

}  // namespace level_difference_test
