// The picture of a receptor's firing shows the model's numbers.
#include "viz/skin/firing_view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "model/physiology/spike_train.h"

namespace firing_view_test {

using namespace tact;

namespace {

std::vector<double> swelling(std::size_t samples) {
    std::vector<double> values;
    for (std::size_t n = 0; n < samples; ++n) {
        const double t_s = static_cast<double>(n) / 10'000.0;
        values.push_back((0.1 + t_s) * std::sin(2.0 * std::numbers::pi * 60.0 * t_s));
    }
    return values;
}

}  // namespace

TEST_CASE("firing: energy gathers, and falls by one for each spike that the model counts") {
    for (const std::size_t samples : {2'000U, 2'350U}) {
        for (const double fires : {3.0, 17.4, 240.0}) {
            CAPTURE(samples);
            CAPTURE(fires);
            const std::vector<double> perceived = swelling(samples);
            const std::vector<double> since = energy_since_spike(perceived, fires);
            const std::vector<int> counts =
                spike_counts(energy_fractions(perceived), fires, WindowSplit::halves);
            REQUIRE(since.size() == samples);
            double whole = 0.0;
            for (const double value : perceived) whole += value * value;
            for (std::size_t n = 1; n < samples; ++n) {
                const double gained = fires * perceived[n] * perceived[n] / whole;
                const bool ends = (n + 1) % kWindowSamples == 0 || n + 1 == samples;
                const std::size_t window = n / kWindowSamples;
                const int fired = ends ? counts[2 * window] + counts[2 * window + 1] : 0;
                CHECK(since[n] == doctest::Approx(since[n - 1] + gained - fired).epsilon(1e-6));
                // The rest at the end of a window is not a spike yet.
                if (ends) CHECK(since[n] < 1.0 + 1e-6);
            }
        }
    }
}

TEST_CASE("firing: silence gathers nothing, and shows its beginning") {
    const std::vector<double> silence(500, 0.0);
    for (const double value : energy_since_spike(silence, 10.0)) CHECK(value == 0.0);
    CHECK(energy_since_spike({}, 10.0).empty());
    CHECK(telling_time_s(std::vector<int>(10, 0)) == std::pair(0.0, 0.05));
}

TEST_CASE("firing: the first dozen spikes are in sight, and a window before them") {
    std::vector<int> spikes(200, 0);
    for (std::size_t step = 60; step < 200; step += 4) spikes[step] = 1;
    const auto [from_s, to_s] = telling_time_s(spikes);
    CHECK(from_s == doctest::Approx(0.29));  // the first is at 0.3 s
    int seen = 0;
    for (std::size_t step = 0; step < spikes.size(); ++step) {
        const double at_s = static_cast<double>(step) * kStepS;
        if (at_s >= from_s && at_s < to_s) seen += spikes[step];
    }
    CHECK(seen >= 12);
    CHECK(seen <= 14);
}

}  // namespace firing_view_test
