#include "model/signal/thinning.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace thinning_test {

using namespace tact;

namespace {

struct Line {
    std::vector<double> places;
    std::vector<double> heights;
};

Line wavy(std::size_t points) {
    Line line;
    for (std::size_t k = 0; k < points; ++k) {
        const double x = 0.01 * static_cast<double>(k * k);
        line.places.push_back(x);
        line.heights.push_back(std::sin(x) + 0.3 * std::sin(7.1 * x));
    }
    return line;
}

double farthest_off(const Line& line, const std::vector<std::size_t>& kept) {
    double most = 0.0;
    for (std::size_t s = 0; s + 1 < kept.size(); ++s) {
        for (std::size_t k = kept[s]; k <= kept[s + 1]; ++k) {
            const double share = (line.places[k] - line.places[kept[s]]) /
                                 (line.places[kept[s + 1]] - line.places[kept[s]]);
            const double height =
                std::lerp(line.heights[kept[s]], line.heights[kept[s + 1]], share);
            most = std::max(most, std::abs(height - line.heights[k]));
        }
    }
    return most;
}

}  // namespace

TEST_CASE("thinning: the corners of a line of straight pieces are all that is kept") {
    Line line;
    for (int k = 0; k <= 100; ++k) {
        line.places.push_back(k);
        line.heights.push_back(k < 30 ? k : k < 70 ? 30.0 : 100.0 - k);
    }
    const Thinning thinning = thinned(line.places, line.heights, 50, 1e-9);
    CHECK(thinning.kept == std::vector<std::size_t>{0, 30, 70, 100});
    CHECK(thinning.largest_error <= 1e-12);
}

TEST_CASE("thinning: the error that is told is the error there is, and within what was asked") {
    const Line line = wavy(80);
    for (const std::size_t most : {2U, 3U, 8U, 20U, 80U}) {
        const Thinning thinning = thinned(line.places, line.heights, most, 0.02);
        CHECK(thinning.kept.size() <= most);
        CHECK(thinning.kept.front() == 0);
        CHECK(thinning.kept.back() == 79);
        CHECK(std::ranges::is_sorted(thinning.kept));
        CHECK(std::abs(thinning.largest_error - farthest_off(line, thinning.kept)) <= 1e-12);
        if (thinning.kept.size() < most) CHECK(thinning.largest_error <= 0.02);
    }
    CHECK(thinned(line.places, line.heights, 80, 0.0).largest_error <= 1e-12);
}

TEST_CASE("thinning: a jump, a point and nothing are lines, too") {
    const std::vector<double> places{0.0, 0.5, 0.5, 1.0};
    const std::vector<double> heights{0.0, 0.0, 1.0, 1.0};
    CHECK(thinned(places, heights, 4, 0.0).kept.size() == 4);
    CHECK(thinned({&places[0], 1}, {&heights[0], 1}, 5, 0.0).kept.size() == 1);
    CHECK(thinned({}, {}, 5, 0.0).kept.empty());
}

}  // namespace thinning_test
