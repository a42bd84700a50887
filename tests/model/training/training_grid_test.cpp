#include "model/training/training_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "model/training/training.h"

namespace training_grid_test {

using namespace tact;

TEST_CASE("training grid: the paper's has 44,289,025 combinations, of which 21,165,625 differ") {
    const TrainingGrid grid = training_grid(10);
    CHECK(combination_count(10) == 44'289'025);
    CHECK(grid.channels.size() == 13'025);
    CHECK(grid.mixes.size() == 65);
    CHECK(kTrainedLayers * grid.channels.size() * grid.mixes.size() == 21'165'625);
}

TEST_CASE("training grid: the classes stand for every combination that gives PM an order") {
    for (const int units : {1, 2, 3, 10}) {
        const TrainingGrid grid = training_grid(units);
        std::uint64_t sum = combinations_of(grid, {});
        for (std::uint32_t mix = 1; mix < grid.mixes.size(); ++mix) {
            for (std::uint32_t channel = 0; channel < grid.channels.size(); ++channel) {
                sum += kTrainedLayers * combinations_of(grid, {0, channel, mix});
            }
        }
        // Without order: both weights zero; NC alone with no channel.
        const auto weights = static_cast<std::uint64_t>(units) + 1;
        const std::uint64_t none =
            kTrainedLayers * (weights * weights * weights * weights + weights - 1);
        CHECK(sum + none == combination_count(units));
    }
}

TEST_CASE("training grid: no two classes are in proportion") {
    const TrainingGrid grid = training_grid(4);
    std::set<ChannelUnits> seen;
    for (std::size_t k = 0; k < grid.channels.size(); ++k) {
        for (int times = 1; times <= static_cast<int>(grid.channel_multiples[k]); ++times) {
            ChannelUnits of = grid.channels[k];
            for (int& weight : of) weight *= times;
            CHECK(seen.insert(of).second);
        }
    }
    CHECK(seen.size() == 5 * 5 * 5 * 5 - 1);
}

TEST_CASE("training grid: mixtures go from OC alone to NC alone") {
    const TrainingGrid grid = training_grid(10);
    CHECK(grid.mixes.front().nc == 0);
    CHECK(grid.mixes.back().oc == 0);
    for (std::size_t k = 1; k < grid.mixes.size(); ++k) {
        CHECK(grid.mixes[k - 1].nc * grid.mixes[k].oc < grid.mixes[k].nc * grid.mixes[k - 1].oc);
    }
}

TEST_CASE("training grid: the paper's parameters are found again as the nearest of their class") {
    const TrainingGrid grid = training_grid(10);
    const PerceptualModelParams paper;
    GridPoint point{3 * 5 + 1, 0, 0};
    while (grid.channels[point.channel] != ChannelUnits{2, 7, 0, 5}) ++point.channel;
    while (grid.mixes[point.mix].nc != 1 || grid.mixes[point.mix].oc != 1) ++point.mix;
    CHECK(combinations_of(grid, point) == 10);
    CHECK(nearest_model(grid, point, paper) == paper);
    PerceptualModelParams other = paper;
    other.nc_weight = other.oc_weight = 0.3;
    CHECK(nearest_model(grid, point, other) == other);
    CHECK(parameter_steps(paper, other, 10) == doctest::Approx(4.0));
}

TEST_CASE("training grid: OC alone leaves layers and channels as they were") {
    const TrainingGrid grid = training_grid(10);
    PerceptualModelParams before;
    before.coding.excitatory_layers = 9;  // outside the grid
    PerceptualModelParams expected = before;
    expected.nc_weight = 0.0;
    CHECK(nearest_model(grid, {}, before) == expected);
}

TEST_CASE(
    "training cost: it counts the grid, adds up over sets and rises with patterns and steps") {
    const auto cost = [](std::vector<std::size_t> patterns, int units) {
        return training_cost(patterns, units);
    };
    const TrainingCost paper = cost({8, 14, 7, 7, 7, 15}, 10);
    CHECK(paper.combinations == 44'289'025);
    CHECK(paper.different == 21'165'625);
    CHECK(paper.one_core_s > 1.0);
    CHECK(paper.one_core_s < 120.0);
    CHECK(cost({}, 10).one_core_s == 0.0);
    const double sum_s = cost({8}, 10).one_core_s + cost({15}, 10).one_core_s;
    CHECK(std::abs(cost({8, 15}, 10).one_core_s - sum_s) <= 1e-9 * sum_s);
    CHECK(cost({9}, 10).one_core_s > cost({8}, 10).one_core_s);
    CHECK(cost({8}, 20).one_core_s > 2.0 * cost({8}, 10).one_core_s);
}

}  // namespace training_grid_test
