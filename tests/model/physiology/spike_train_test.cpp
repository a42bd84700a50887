#include "model/physiology/spike_train.h"

#include <numeric>

#include "tests/support/golden.h"

namespace spike_train_test {

using namespace tact;

TEST_CASE("spikes: counts add up to the impulses owed, rounded down") {
    const auto fractions = energy_fractions(golden::noise(3, 10'000, 1.0).samples_g);
    for (const double fires : {0.0, 0.4, 1.0, 37.9, 151.0, 5000.0}) {
        const auto counts = spike_counts(fractions, fires, WindowSplit::halves);
        CHECK(counts.size() == 200);
        CHECK(std::accumulate(counts.begin(), counts.end(), 0) == static_cast<int>(fires));
        CHECK(std::ranges::all_of(counts, [](int count) { return count >= 0; }));
    }
}

TEST_CASE("spikes: doubling the amplitude changes no count, as energy is shared, not measured") {
    auto waveform = golden::noise(4, 3000, 1.0).samples_g;
    const auto once = spike_counts(energy_fractions(waveform), 88.0, WindowSplit::halves);
    for (double& sample : waveform) sample *= 2.0;
    CHECK(spike_counts(energy_fractions(waveform), 88.0, WindowSplit::halves) == once);
}

TEST_CASE("spikes: doubling the amplitude of a silent channel still gives none") {
    const std::vector<double> silence(500, 0.0);
    const auto counts = spike_counts(energy_fractions(silence), 100.0, WindowSplit::halves);
    CHECK(counts == std::vector<int>(10, 0));
}

TEST_CASE("spikes: the odd spike of a window falls into its first half") {
    const std::vector<double> one_window{1.0};
    CHECK(spike_counts(one_window, 7.0, WindowSplit::halves) == std::vector<int>{4, 3});
    CHECK(spike_counts(one_window, 7.0, WindowSplit::first) == std::vector<int>{7, 0});
}

TEST_CASE("spikes: the last window may be cut short but counts as one") {
    CHECK(step_count(0) == 0);
    CHECK(step_count(1) == 2);
    CHECK(step_count(100) == 2);
    CHECK(step_count(101) == 4);
    CHECK(energy_fractions(std::vector<double>(101, 1.0)).back() == 1.0);
}

TEST_CASE("spikes: n spikes in a step are evenly spread and never share a sample up to 50") {
    CHECK(spread_spikes(0).empty());
    CHECK(spread_spikes(3) == std::vector<std::size_t>{0, 16, 33});
    for (int count = 1; count <= 50; ++count) {
        const auto offsets = spread_spikes(count);
        CHECK(offsets.front() == 0);
        CHECK(offsets.back() < kStepSamples);
        CHECK(std::ranges::adjacent_find(offsets) == offsets.end());
    }
}

TEST_CASE("spikes: a share of impulses that is whole but for rounding is whole") {
    // 0.29 * 100 is 28.999999999999996 in binary; so is 29 - 5e-10 for the model.
    CHECK(spike_counts(std::vector{0.29, 1.0}, 100.0, WindowSplit::first) ==
          std::vector<int>{29, 0, 71, 0});
    CHECK(spike_counts(std::vector{1.0}, 29.0 - 5e-10, WindowSplit::first)[0] == 29);
    CHECK(spike_counts(std::vector{1.0}, 29.0 - 5e-9, WindowSplit::first)[0] == 28);
}

TEST_CASE("spikes: impulses beyond any number of a receptor's are many, not negative") {
    for (const double fires : {3e9, 1e15, 1e300}) {
        for (const int count : spike_counts(std::vector{0.5, 1.0}, fires, WindowSplit::halves)) {
            CHECK(count >= 400'000);
            CHECK(count <= 1'000'000);
        }
    }
}

TEST_CASE("spikes: more spikes than samples in a step are one in every sample") {
    for (const int count : {51, 1000, 2'000'000'000})
        CHECK(spread_spikes(count) == spread_spikes(50));
}

}  // namespace spike_train_test
