#include "model/planning/deciding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>
#include <utility>

#include "model/common/parallel.h"
#include "model/common/random.h"
#include "model/dissimilarity/correlation.h"

namespace tact {

namespace {

using Places = std::vector<std::size_t>;

// A subset on which one of the two says nothing decides nothing.
constexpr double kNothing = 2.0;

double rho_on(const Dissimilarity& one, const Dissimilarity& other, const Places& places) {
    std::vector<double> a;
    std::vector<double> b;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = i + 1; j < places.size(); ++j) {
            const auto [first, second] = std::minmax(places[i], places[j]);
            a.push_back(one(first, second));
            b.push_back(other(first, second));
        }
    }
    const double rho = spearman(a, b);
    return std::isnan(rho) ? kNothing : rho;
}

struct Chosen {
    Places places;
    double rho = kNothing;
};

// The first `count` of an order, and exchanges with the rest while one lowers rho.
Chosen exchanged(const Dissimilarity& one, const Dissimilarity& other, Places order,
                 std::size_t count, const std::stop_token& stop) {
    constexpr double kLower = 1e-12;
    Places inside(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    Places outside(order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    double rho = rho_on(one, other, inside);
    while (!stop.stop_requested()) {
        double lowest = rho - kLower;
        std::pair<std::size_t, std::size_t> best{count, 0};
        for (std::size_t i = 0; i < inside.size(); ++i) {
            for (std::size_t o = 0; o < outside.size(); ++o) {
                std::swap(inside[i], outside[o]);
                const double then = rho_on(one, other, inside);
                std::swap(inside[i], outside[o]);
                if (then >= lowest) continue;
                lowest = then;
                best = {i, o};
            }
        }
        if (best.first == count) break;
        std::swap(inside[best.first], outside[best.second]);
        rho = lowest;
    }
    std::ranges::sort(inside);
    return {std::move(inside), rho};
}

}  // namespace

std::optional<DecidingPatterns> deciding_patterns(const Dissimilarity& one,
                                                  const Dissimilarity& other, std::size_t count,
                                                  const DecidingParams& params) {
    assert(one.size == other.size && "matrices of the same patterns");
    assert(count >= 3 && count <= one.size && "some of the patterns");
    std::vector<Chosen> found(std::max<std::size_t>(params.starts, 1));
    std::mutex reporting;
    std::size_t done = 0;
    parallel_for(found.size(), params.threads, params.stop, [&](std::size_t start) {
        RandomStream random{random_bits(params.seed, start)};
        Places order(one.size);
        next_permutation_of(random, order);
        found[start] = exchanged(one, other, std::move(order), count, params.stop);
        const std::lock_guard lock(reporting);
        ++done;
        if (params.progress) {
            params.progress(static_cast<double>(done) / static_cast<double>(found.size()));
        }
    });
    if (params.stop.stop_requested()) return std::nullopt;
    const Chosen& best = *std::ranges::min_element(found, {}, &Chosen::rho);
    return DecidingPatterns{
        best.places, best.rho == kNothing ? std::numeric_limits<double>::quiet_NaN() : best.rho,
        spearman(one.condensed, other.condensed)};
}

}  // namespace tact
