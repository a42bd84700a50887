// Numbers from the design page's worked examples, and a search of all paths.
#include "model/metrics/raw_dtw.h"

#include "model/dtw/dtw.h"
#include "tests/support/dtw_textbook.h"
#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace raw_dtw_test {

using namespace tact;

namespace {

using Signal = std::vector<double>;

const Signal kFour{1.0, 3.0, 4.0, 9.0};
const Signal kFive{1.0, 3.0, 7.0, 8.0, 9.0};

RawDtwParams with(DtwNormalisation normalisation) {
    RawDtwParams params;
    params.normalisation = normalisation;
    return params;
}

RawDtwParams with_band(std::size_t samples) {
    RawDtwParams params;
    params.band_samples = samples;
    return params;
}

// The cheapest of all paths from (i, j) to the end that stay within `band` of the diagonal, found
// by trying each one.
double cheapest(const Signal& x, const Signal& y, std::size_t i, std::size_t j, std::size_t band) {
    if (i == x.size() || j == y.size() || (i > j ? i - j : j - i) > band) return INFINITY;
    const double here = std::abs(x[i] - y[j]);
    if (i + 1 == x.size() && j + 1 == y.size()) return here;
    return here + std::min({cheapest(x, y, i + 1, j + 1, band), cheapest(x, y, i + 1, j, band),
                            cheapest(x, y, i, j + 1, band)});
}

}  // namespace

TEST_CASE("raw DTW: the worked examples") {
    CHECK(raw_dtw(Signal{0, 1, 2, 1, 0}, Signal{0, 0, 1, 2, 2, 1, 0}) == 0.0);
    CHECK(raw_dtw(kFour, kFive) == 4.0);
    CHECK(raw_dtw(kFour, kFive, with(DtwNormalisation::path_length)) == 0.8);
    CHECK(std::abs(raw_dtw(kFour, kFive, with(DtwNormalisation::sum_of_lengths)) - 4.0 / 9.0) <=
          1e-16);
    RawDtwParams squared;
    squared.cost = DtwCost::squared;
    CHECK(raw_dtw(kFour, kFive, squared) == 6.0);
    squared.takes_root = true;
    CHECK(std::abs(raw_dtw(kFour, kFive, squared) - 2.449489742783) <= 5e-13);
    CHECK(raw_dtw(Signal(3, 2.0), Signal(4, 5.0)) == 12.0);
    CHECK(raw_dtw(Signal{2}, Signal{1, 4, 2}) == 3.0);
    const Signal low_high{0, 0, 1, 1};
    const Signal high_low{1, 1, 0, 0};
    CHECK(raw_dtw(low_high, high_low) == 4.0);
    CHECK(raw_dtw(low_high, high_low, with_band(0)) == 4.0);
    const auto sines = [](double f_hz) { return tone(f_hz, 50.0, 50).samples_g; };
    CHECK(std::abs(raw_dtw(sines(2.0), sines(3.0)) - 13.0649457957637) <= 1e-13);
}

TEST_CASE("raw DTW: a band wide enough changes nothing, and none leaves the diagonal") {
    const Signal x = golden::noise(1, 60, 1.0).samples_g;
    const Signal y = golden::noise(2, 60, 1.0).samples_g;
    CHECK(raw_dtw(x, y, with_band(60)) == dtw_textbook(x, y));
    double apart = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) apart += std::abs(x[n] - y[n]);
    CHECK(std::abs(raw_dtw(x, y, with_band(0)) - apart) <= 1e-13);
    double before = INFINITY;
    for (const std::size_t band : {0UL, 1UL, 2UL, 5UL, 20UL, 60UL}) {
        const double now = raw_dtw(x, y, with_band(band));
        CHECK(now <= before);
        before = now;
    }
}

TEST_CASE("raw DTW: with a band it is the cheapest of all paths within it") {
    for (std::uint32_t seed = 1; seed < 8; ++seed) {
        const Signal x = golden::noise(seed, 7, 1.0).samples_g;
        const Signal y = golden::noise(seed + 100, 7, 1.0).samples_g;
        for (const std::size_t band : {0UL, 1UL, 3UL}) {
            CHECK(std::abs(raw_dtw(x, y, with_band(band)) - cheapest(x, y, 0, 0, band)) <= 1e-14);
        }
    }
}

TEST_CASE("raw DTW: signals of unlike lengths have a path in any band") {
    const Signal many = golden::noise(3, 40, 1.0).samples_g;
    for (const std::size_t count : {1UL, 2UL, 3UL, 17UL, 39UL}) {
        const Signal few = golden::noise(4, count, 1.0).samples_g;
        const double narrow = raw_dtw(many, few, with_band(0));
        CHECK(std::isfinite(narrow));
        CHECK(narrow >= raw_dtw(many, few, with_band(5)));
    }
}

TEST_CASE("raw DTW: symmetric to the bit in every form, also where paths are equally good") {
    const std::vector<Signal> signals{{1, 3, 4, 9},
                                      {1, 3, 7, 8, 9},
                                      {0, 0, 1, 1, 0},
                                      {1, 0, 1, 0, 1, 0, 0},
                                      golden::noise(8, 33, 1.0).samples_g,
                                      golden::noise(9, 20, 1.0).samples_g,
                                      Signal(12, 0.0)};
    for (const auto cost : {DtwCost::absolute, DtwCost::squared}) {
        for (const auto normalisation : {DtwNormalisation::none, DtwNormalisation::path_length,
                                         DtwNormalisation::sum_of_lengths}) {
            for (const std::optional<std::size_t> band : {std::optional<std::size_t>{}, {2UL}}) {
                const RawDtwParams params{cost, false, normalisation, band};
                for (const Signal& x : signals) {
                    CHECK(raw_dtw(x, x, params) == 0.0);
                    for (const Signal& y : signals) {
                        CHECK(raw_dtw(x, y, params) == raw_dtw(y, x, params));
                    }
                }
            }
        }
    }
}

TEST_CASE("raw DTW: by default the bits of the model's DTW, and of nothing there is no path") {
    const Signal x = golden::noise(6, 90, 1.0).samples_g;
    const Signal y = golden::noise(7, 77, 1.0).samples_g;
    CHECK(raw_dtw(x, y) == dtw(x, y));
    for (const auto& params : {RawDtwParams{}, with_band(1), with(DtwNormalisation::path_length),
                               with(DtwNormalisation::sum_of_lengths)}) {
        CHECK(raw_dtw({}, {}, params) == 0.0);
        CHECK(std::isinf(raw_dtw(x, {}, params)));
        CHECK(std::isinf(raw_dtw({}, x, params)));
    }
}

}  // namespace raw_dtw_test
