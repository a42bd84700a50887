#include "model/metrics/van_rossum.h"

#include "tests/support/golden.h"

namespace van_rossum_test {

using namespace tact;

namespace {

constexpr PerReceptor<double> kOnes{1.0, 1.0, 1.0, 1.0};

// Spikes of the first channel at the samples given; `second` of the second.
NeuralCode code_of(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second) {
    NeuralCode code;
    code.samples = 2000;
    code.central_spikes.assign(2000, 0);
    for (const std::size_t n : first) code.central_spikes[n] |= 1U;
    for (const std::size_t n : second) code.central_spikes[n] |= 2U;
    return code;
}

double apart(const NeuralCode& x, const NeuralCode& y, const VanRossumParams& params = {}) {
    return van_rossum(spike_tails(x, kOnes, params), spike_tails(y, kOnes, params), params);
}

}  // namespace

TEST_CASE("van Rossum: one spike is sqrt 1/2 from silence, wherever it is") {
    const NeuralCode silence = code_of({}, {});
    for (const std::size_t n : {0UL, 700UL, 1999UL}) {
        CHECK(std::abs(apart(code_of({n}, {}), silence) - std::sqrt(0.5)) <= 1e-12);
    }
    CHECK(apart(silence, silence) == 0.0);
}

TEST_CASE("van Rossum: two spikes are sqrt(1 - exp(-dt / tau)) apart") {
    for (const std::size_t gap : {1UL, 10UL, 100UL, 900UL}) {
        const double dt_s = static_cast<double>(gap) / kModelRateHz;
        const double expected = std::sqrt(1.0 - std::exp(-dt_s / 0.010));
        const double found = apart(code_of({500}, {}), code_of({500 + gap}, {}));
        CHECK(std::abs(found - expected) <= 1e-12);
    }
}

TEST_CASE("van Rossum: together channels stand for each other, one by one they do not") {
    const NeuralCode first = code_of({500}, {});
    const NeuralCode second = code_of({}, {500});
    CHECK(apart(first, second) == 0.0);
    VanRossumParams params;
    params.lines = SpikeLines::one_by_one;
    CHECK(std::abs(apart(first, second, params) - 1.0) <= 1e-12);
}

TEST_CASE("van Rossum: nothing is at 0 from nothing") {
    CHECK(apart(NeuralCode{}, NeuralCode{}) == 0.0);
}

}  // namespace van_rossum_test
