#include "model/ask/path_overview.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace tact {

namespace {

constexpr std::size_t kParts = 32;
constexpr int kBisections = 4;  // of as many parts, where the way goes farthest
constexpr double kSmallestJump = 1e-5;

PathDistances::Pairs all_pairs_of(const std::vector<double>& shares) {
    PathDistances::Pairs pairs;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        for (std::size_t j = i + 1; j < shares.size(); ++j) {
            pairs.emplace_back(shares[i], shares[j]);
        }
    }
    return pairs;
}

// Halves the parts over which the way goes farthest; false when stopped.
bool bisect(PathDistances& path, std::vector<double>& shares) {
    const auto pairs = neighbours_of(shares);
    const std::vector<double> far = path.of(pairs, false);
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t k) { return far[k]; });
    for (std::size_t k = 0; k < kParts / 2; ++k) {
        shares.push_back(0.5 * (pairs[order[k]].first + pairs[order[k]].second));
    }
    std::ranges::sort(shares);
    return path.prepare(shares);
}

}  // namespace

PathDistances::Pairs neighbours_of(const std::vector<double>& shares) {
    PathDistances::Pairs pairs;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        pairs.emplace_back(shares[k], shares[k + 1]);
    }
    return pairs;
}

bool look_over(PathDistances& path, PathOverview& overview) {
    for (std::size_t k = 0; k <= kParts; ++k) {
        overview.shares.push_back(static_cast<double>(k) / static_cast<double>(kParts));
    }
    if (!path.prepare(overview.shares)) return false;
    path.scale_by(all_pairs_of(overview.shares));
    for (int round = 0; round < kBisections; ++round) {
        if (!bisect(path, overview.shares)) return false;
    }
    measure(path, overview);
    return true;
}

void measure(const PathDistances& path, PathOverview& overview) {
    const std::size_t n = overview.shares.size();
    const std::vector<double> flat = path.of(all_pairs_of(overview.shares), false);
    overview.coarse.assign(n * n, 0.0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) overview.coarse[i * n + j] = flat[at++];
    }
}

// Halves where more of the way is, until a jump is all that is left.
std::optional<PathJump> largest_jump(PathDistances& path, const PathOverview& overview) {
    const std::size_t n = overview.shares.size();
    std::size_t worst = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        if (overview.coarse[k * n + k + 1] > overview.coarse[worst * n + worst + 1]) worst = k;
    }
    double low = overview.shares[worst];
    double high = overview.shares[worst + 1];
    while (high - low > kSmallestJump) {
        const double middle = 0.5 * (low + high);
        if (!path.prepare({low, middle, high})) return std::nullopt;
        const auto halves = path.of({{low, middle}, {middle, high}}, false);
        (halves[0] >= halves[1] ? high : low) = middle;
    }
    return PathJump{low, path.of({{low, high}}, true).front()};
}

}  // namespace tact
