#include "model/signal/waveform.h"

#include <numeric>

#include "tests/support/golden.h"

namespace waveform_test {

using namespace tact;

TEST_CASE("waveform: peak and rms of a sine, and of nothing") {
    const Waveform sine = render(Pattern{});
    CHECK(std::abs(peak_g(sine) - 1.0) <= 1e-3);  // no sample need hit the crest
    CHECK(std::abs(rms_g(sine) - std::sqrt(0.5)) <= 1e-12);
    CHECK(duration_s(sine) == 1.0);
    CHECK(peak_g(Waveform{}) == 0.0);
    CHECK(rms_g(Waveform{}) == 0.0);
}

TEST_CASE("waveform: padding adds zeros at the end and never shortens") {
    const Waveform short_one{kModelRateHz, {1.0, 2.0}};
    CHECK(padded(short_one, 4).samples_g == std::vector<double>{1.0, 2.0, 0.0, 0.0});
    CHECK(padded(short_one, 1) == short_one);
}

TEST_CASE("waveform: without its mean a waveform sums to nothing") {
    const auto centred = without_mean(std::vector<double>{1.0, 2.0, 6.0});
    CHECK(std::abs(std::accumulate(centred.begin(), centred.end(), 0.0)) <= 1e-15);
    CHECK(without_mean({}).empty());
}

TEST_CASE("waveform: a peak among which is NaN is NaN, wherever it stands") {
    const double nan = std::nan("");
    for (const std::vector<double>& samples :
         {std::vector<double>{nan}, {nan, 1.0}, {1.0, nan}, {-2.0, nan, 1.0}}) {
        CHECK(std::isnan(peak_g({kModelRateHz, samples})));
    }
}

}  // namespace waveform_test
