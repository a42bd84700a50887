#include <algorithm>

#include "model/morph/blend.h"
#include "model/morph/morph_parts.h"

namespace tact {

namespace {

std::vector<Transient> in_order(std::vector<Transient> transients) {
    std::ranges::stable_sort(transients, {}, &Transient::time_s);
    return transients;
}

Transient transient_between(const Transient& a, const Transient& b, double share) {
    return {between(a.time_s, b.time_s, share, BlendBy::difference),
            between(a.amplitude_g, b.amplitude_g, share, BlendBy::ratio),
            between(a.frequency_hz, b.frequency_hz, share, BlendBy::ratio),
            between(a.duration_s, b.duration_s, share, BlendBy::ratio),
            share < 0.5 ? a.shape : b.shape};
}

// The cheapest partners in order: every one of the fewer has one, the others fade.
std::vector<std::size_t> partners_of(const std::vector<Transient>& fewer,
                                     const std::vector<Transient>& more) {
    const std::size_t n = fewer.size();
    const std::size_t m = more.size();
    // cost[k][j]: the first k have partners among the first j.
    std::vector<std::vector<double>> cost(n + 1, std::vector<double>(m + 1, 0.0));
    for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t j = k; j <= m; ++j) {
            const double moved = std::abs(fewer[k - 1].time_s - more[j - 1].time_s);
            cost[k][j] = cost[k - 1][j - 1] + moved;
            if (j > k) cost[k][j] = std::min(cost[k][j], cost[k][j - 1]);
        }
    }
    std::vector<std::size_t> partners(n);
    for (std::size_t k = n, j = m; k > 0; --k, --j) {
        while (j > k && cost[k][j] == cost[k][j - 1]) --j;
        partners[k - 1] = j - 1;
    }
    return partners;
}

}  // namespace

std::vector<Transient> transients_between(const Pattern& from, const Pattern& to, double share) {
    const std::vector<Transient> a = in_order(from.transients);
    const std::vector<Transient> b = in_order(to.transients);
    const bool grows = b.size() >= a.size();
    const std::vector<Transient>& fewer = grows ? a : b;
    const std::vector<Transient>& more = grows ? b : a;
    std::vector<Transient> result = more;
    for (Transient& one : result) one.amplitude_g *= grows ? share : 1.0 - share;
    const std::vector<std::size_t> partners = partners_of(fewer, more);
    for (std::size_t k = 0; k < partners.size(); ++k) {
        const std::size_t j = partners[k];
        result[j] = transient_between(grows ? a[k] : a[j], grows ? b[j] : b[k], share);
    }
    return result;
}

}  // namespace tact
