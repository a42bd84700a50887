// Numbers from the design page's worked examples.
#include "model/metrics/temporal_matching.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace temporal_matching_test {

using namespace tact;

namespace {

using Signal = std::vector<double>;

double mtm(const Signal& x, const Signal& y, const TemporalMatchingParams& params = {}) {
    return temporal_matching(centred_samples(x, params), centred_samples(y, params), params);
}

}  // namespace

TEST_CASE("Mtm: the worked examples") {
    const Signal rising{1, 2, 3, 4};
    CHECK(mtm(rising, {2, 4, 6, 8}) == 0.0);
    CHECK(mtm(rising, {8, 6, 4, 2}) == 2.0);
    CHECK(std::abs(mtm({1, 0, -1, 0}, {1, 1, -1, -1}) - 0.292893218813453) <= 1e-15);
}

TEST_CASE("Mtm: the AM set is orthogonal over 1 s, so all pairs are 1 apart: the paper's tie") {
    std::vector<Signal> patterns;
    for (const double f_hz : {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
        Pattern pattern;
        pattern.modulation.frequency_hz = f_hz;
        patterns.push_back(render(pattern).samples_g);
    }
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        for (std::size_t j = i + 1; j < patterns.size(); ++j) {
            CHECK(std::abs(mtm(patterns[i], patterns[j]) - 1.0) <= 1e-14);
        }
    }
}

TEST_CASE("Mtm: amplitude and offset change nothing, sign and shift do") {
    const Waveform x = golden::noise(1, 800, 1.0);
    const Waveform y = golden::noise(2, 800, 1.0);
    const double apart = mtm(x.samples_g, y.samples_g);
    Signal changed = mixed(0.3, y, 0.0, y).samples_g;
    for (double& sample : changed) sample += 0.7;
    CHECK(std::abs(mtm(x.samples_g, changed) - apart) <= 1e-13);
    CHECK(mtm(y.samples_g, changed) <= 1e-14);
    const Signal turned = mixed(-1.0, y, 0.0, y).samples_g;
    CHECK(std::abs(mtm(x.samples_g, turned) - (2.0 - apart)) <= 1e-13);
    TemporalMatchingParams either;
    either.sign = CorrelationSign::dropped;
    CHECK(std::abs(mtm(x.samples_g, turned, either) - mtm(x.samples_g, y.samples_g, either)) <=
          1e-15);
    const Signal sine = tone(100.0, 10'000.0, 1000).samples_g;
    Signal quarter = sine;
    std::ranges::rotate(quarter, quarter.begin() + 25);
    CHECK(std::abs(mtm(sine, quarter) - 1.0) <= 1e-13);
}

TEST_CASE("Mtm: over all lags, a shifted burst is found again") {
    TemporalMatchingParams any_lag;
    any_lag.lag = CorrelationLag::best;
    Signal early(400, 0.0);
    Signal late(400, 0.0);
    const Signal burst = tone(300.0, 10'000.0, 100).samples_g;  // whole cycles: no mean
    std::ranges::copy(burst, early.begin() + 20);
    std::ranges::copy(burst, late.begin() + 230);
    CHECK(std::abs(mtm(early, late) - 1.0) <= 1e-14);
    CHECK(mtm(early, late, any_lag) <= 1e-13);
    CHECK(mtm(early, late, any_lag) == mtm(late, early, any_lag));
}

TEST_CASE("Mtm: what is constant is silent: 0 from its like, 1 from sound") {
    const Signal silence(100, 0.0);
    const Signal sound = tone(200.0, 10'000.0, 100).samples_g;
    for (const double offset_g : {0.1, 1.0 / 3.0, 1000.1}) {
        const Signal constant(100, offset_g);
        CHECK(mtm(silence, constant) == 0.0);
        CHECK(mtm(constant, sound) == 1.0);
    }
    CHECK(mtm(silence, silence) == 0.0);
    CHECK(mtm(silence, sound) == 1.0);
    CHECK(mtm({}, {}) == 0.0);
}

}  // namespace temporal_matching_test
