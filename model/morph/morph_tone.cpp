#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/morph/morph_parts.h"

namespace tact {

namespace {

// How strongly the carriers themselves are felt, and their side bands, as the modulation has them.
struct Strengths {
    double carriers = 1.0;
    double side_bands = 0.0;
    std::optional<double> at_hz{};  // of the modulation, if there is one
};

Strengths strengths_of(const Modulation& modulation) {
    const auto& [kind, frequency_hz, depth] = modulation;
    const bool am = kind == ModulationKind::am;
    if (frequency_hz == 0.0 || (am && depth == 0.0)) return {};
    return {am ? 1.0 : 0.0, am ? depth : 1.0, frequency_hz};
}

// Carriers of both, in their order.
std::vector<Carrier> carriers_between(const Pattern& from, const Pattern& to, double share) {
    const std::size_t count = std::max({std::size_t{1}, from.carriers.size(), to.carriers.size()});
    const auto carrier_of = [](const Pattern& own, const Pattern& other, std::size_t k) {
        if (k < own.carriers.size()) return own.carriers[k];
        Carrier silent = k < other.carriers.size() ? other.carriers[k] : Carrier{};
        silent.weight = 0.0;
        return silent;
    };
    std::vector<Carrier> carriers;
    for (std::size_t k = 0; k < count; ++k) {
        const auto [a_hz, a_weight, a_rad] = carrier_of(from, to, k);
        const auto [b_hz, b_weight, b_rad] = carrier_of(to, from, k);
        carriers.push_back({between(a_hz, b_hz, share, BlendBy::ratio),
                            between(a_weight, b_weight, share, BlendBy::difference),
                            between(a_rad, b_rad, share, BlendBy::difference)});
    }
    return carriers;
}

// sin(2 pi m t) w sin(2 pi f t + phi) as two sines; none where one would not move at all.
std::optional<std::vector<Carrier>> side_bands_of(const Carrier& carrier, double at_hz) {
    constexpr double kQuarter = std::numbers::pi / 2.0;
    const auto& [frequency_hz, weight, phase_rad] = carrier;
    const double low_hz = frequency_hz - at_hz;
    const double high_hz = frequency_hz + at_hz;
    if (std::abs(low_hz) < limits::kCarrierHz.low || high_hz > limits::kCarrierHz.high) {
        return std::nullopt;
    }
    Carrier low{low_hz, 0.5 * weight, phase_rad + kQuarter};
    // Below 0 Hz it is the same sine, turned.
    if (low_hz < 0.0) low = {-low_hz, -low.weight, -low.phase_rad};
    return std::vector<Carrier>{low, {high_hz, 0.5 * weight, phase_rad - kQuarter}};
}

// The modulation written out as carriers.
std::optional<MorphedTone> written_out(std::vector<Carrier> carriers, const Strengths& strengths) {
    MorphedTone tone;
    for (Carrier& carrier : carriers) {
        const auto bands = side_bands_of(carrier, *strengths.at_hz);
        if (!bands) return std::nullopt;
        for (Carrier band : *bands) {
            band.weight *= strengths.side_bands;
            tone.carriers.push_back(band);
        }
        carrier.weight *= strengths.carriers;
    }
    tone.carriers.insert(tone.carriers.begin(), carriers.begin(), carriers.end());
    if (tone.carriers.size() > limits::kMaxCarriers) return std::nullopt;
    return tone;
}

}  // namespace

std::optional<MorphedTone> tone_between(const Pattern& from, const Pattern& to, double share) {
    const Strengths a = strengths_of(from.modulation);
    const Strengths b = strengths_of(to.modulation);
    std::vector<Carrier> carriers = carriers_between(from, to, share);
    if (!a.at_hz && !b.at_hz) return MorphedTone{std::move(carriers), {}};
    Strengths way{between(a.carriers, b.carriers, share, BlendBy::difference),
                  between(a.side_bands, b.side_bands, share, BlendBy::difference),
                  between(a.at_hz.value_or(*(b.at_hz ? b.at_hz : a.at_hz)),
                          b.at_hz.value_or(*(a.at_hz ? a.at_hz : b.at_hz)), share, BlendBy::ratio)};
    if (a.carriers == 1.0 && b.carriers == 1.0) {
        return MorphedTone{std::move(carriers), {ModulationKind::am, *way.at_hz, way.side_bands}};
    }
    if (a.carriers == 0.0 && b.carriers == 0.0) {
        return MorphedTone{std::move(carriers), {ModulationKind::product, *way.at_hz, 1.0}};
    }
    // Carriers follow a drawn frequency in proportion, which side bands do not.
    if (!from.frequency_curve.empty() || !to.frequency_curve.empty()) return std::nullopt;
    return written_out(std::move(carriers), way);
}

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
