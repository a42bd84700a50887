// Where an accent meets the carrier is in no format, so PM may not hang on it.
//
// It is not held that an accent over a tone costs no more than a lone tick does where both are
// moved by 3 ms. Measured, a lone tick moved costs OC 0, as its envelope is the same, and NC 0.026
// to 0.037; over a tone the stretches before and behind the accent change their lengths, which
// costs OC 0.5 and NC up to 0.089. What is held: its level is never lowered and moves by less than
// 2 dB (tests/model/pattern/accents_test.cpp), and moved, it stays nearer to itself than to none.
#include <doctest/doctest.h>

#include <algorithm>

#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model.h"

namespace accents_in_pm_test {

using namespace tact;

namespace {

constexpr double kStartsS[] = {0.1, 0.101, 0.102, 0.103};

Waveform accent_at(double t_s, double carrier_g) {
    Pattern pattern;
    pattern.amplitude_g = carrier_g;
    pattern.duration_s = 0.3;
    pattern.transients = {{t_s, 1.6, 150.0, 0.022, TransientShape::sine}};
    return render(pattern);
}

Waveform carrier() {
    Pattern pattern;
    pattern.amplitude_g = 0.9;
    pattern.duration_s = 0.3;
    return render(pattern);
}

// The largest of the pairs among the four patterns from that place on.
double most_of(const Dissimilarity& matrix, std::size_t from) {
    double most = 0.0;
    for (std::size_t i = from; i < from + 4; ++i) {
        for (std::size_t j = i + 1; j < from + 4; ++j) most = std::max(most, matrix(i, j));
    }
    return most;
}

}  // namespace

TEST_CASE(
    "accents in PM: moved by up to 3 ms one is nearer to itself than to none or to a lone one") {
    std::vector<Waveform> waveforms;
    for (const double t_s : kStartsS) waveforms.push_back(accent_at(t_s, 0.9));
    for (const double t_s : kStartsS) waveforms.push_back(accent_at(t_s, 0.0));
    waveforms.push_back(carrier());
    const auto prediction = predict(waveforms, {});
    REQUIRE(prediction);
    const double moved = most_of(prediction->pm, 0);
    double to_none = 1e9;
    for (std::size_t k = 0; k < 4; ++k) to_none = std::min(to_none, prediction->pm(k, 8));
    CHECK(moved < to_none);
    CHECK(moved < prediction->pm(0, 4));
    // Its rhythm stays what it is; spikes shift with it, as a lone tick's do.
    CHECK(most_of(prediction->oc, 0) < 0.02 * prediction->oc(0, 8));
    CHECK(most_of(prediction->nc, 0) < 0.25 * prediction->nc(0, 4));
}

}  // namespace accents_in_pm_test
