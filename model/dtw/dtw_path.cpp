#include "model/dtw/dtw_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tact {

namespace {

enum Step : std::uint8_t { diagonal, down, right };

}  // namespace

DtwPath dtw_path(std::span<const double> a, std::span<const double> b, double waiting_cost) {
    assert(a.empty() == b.empty() && "a way needs two signals");
    DtwPath path;
    if (a.empty() || b.empty()) return path;
    const std::size_t n = b.size();
    std::vector<std::uint8_t> came(a.size() * n, diagonal);
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    std::vector<double> above(n + 1, kNowhere);  // D[i-1, j-1] at j
    std::vector<double> row(n + 1, kNowhere);
    above[0] = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        row[0] = kNowhere;
        for (std::size_t j = 0; j < n; ++j) {
            double least = above[j];
            Step step = diagonal;
            const double down_to = above[j + 1] + waiting_cost;
            const double right_to = row[j] + waiting_cost;
            if (down_to < least) {
                least = down_to;
                step = down;
            }
            if (right_to < least) {
                least = right_to;
                step = right;
            }
            row[j + 1] = std::abs(a[i] - b[j]) + least;
            came[i * n + j] = step;
        }
        std::swap(above, row);
    }
    path.distance = above[n];
    std::size_t i = a.size() - 1;
    std::size_t j = n - 1;
    for (;;) {
        path.steps.emplace_back(i, j);
        if (i == 0 && j == 0) break;
        const std::uint8_t step = came[i * n + j];
        if (step != right) --i;
        if (step != down) --j;
    }
    std::ranges::reverse(path.steps);
    return path;
}

}  // namespace tact
