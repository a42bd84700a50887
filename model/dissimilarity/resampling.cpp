#include "model/dissimilarity/resampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/common/distributions.h"
#include "model/common/random.h"

namespace tact {

namespace {

using Places = std::vector<std::size_t>;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

// Numbers of at most 2 that differ by less differ by rounding alone.
constexpr double kStill = 1e-12;

// Every multiset of `count` out of as many with its share of all ordered draws:
// count! / prod m_i! / count^count.
void add_multisets(std::size_t count, std::size_t next, double share, Places& taken,
                   std::vector<ObjectDraw>& all) {
    const std::size_t room = count - taken.size();
    if (next + 1 == count || room == 0) {
        Places whole = taken;
        for (std::size_t k = 1; k <= room; ++k) {
            whole.push_back(next);
            share /= static_cast<double>(k);
        }
        all.push_back({std::move(whole), share});
        return;
    }
    const std::size_t size = taken.size();
    for (std::size_t copies = 0; copies <= room; ++copies) {
        add_multisets(count, next + 1, share, taken, all);
        taken.push_back(next);
        share /= static_cast<double>(copies + 1);
    }
    taken.resize(size);
}

}  // namespace

std::vector<std::size_t> drawn_objects(std::size_t count, std::uint64_t seed, std::size_t draw) {
    RandomStream random{random_bits(seed, draw)};
    Places drawn(count);
    for (std::size_t& place : drawn) place = next_index(random, count);
    return drawn;
}

std::vector<ObjectDraw> object_draws(std::size_t count, std::size_t draws, std::uint64_t seed) {
    std::vector<ObjectDraw> all;
    if (count > 0 && count <= kExactObjects) {
        double share = 1.0;
        for (std::size_t k = 1; k <= count; ++k) {
            share *= static_cast<double>(k) / static_cast<double>(count);
        }
        Places taken;
        add_multisets(count, 0, share, taken, all);
        return all;
    }
    for (std::size_t draw = 0; draw < draws; ++draw) {
        all.push_back({drawn_objects(count, seed, draw)});
    }
    return all;
}

const char* words(NotKnown why) {
    switch (why) {
        case NotKnown::known:
            return "";
        case NotKnown::no_value:
            return "the number itself is undefined";
        case NotKnown::one_person:
            return "there are not two people";
        case NotKnown::still:
            return "no resample moves it: pairs are too few or answers equal";
        case NotKnown::alike:
            return "both rank every pair alike";
        case NotKnown::undefined:
            return "undefined in most resamples";
    }
    return "";
}

StandardError bootstrap_error(std::span<const Weighed> draws) {
    double all = 0.0;
    double known = 0.0;
    double sum = 0.0;
    std::size_t count = 0;
    for (const Weighed& draw : draws) {
        all += draw.weight;
        if (std::isnan(draw.value)) continue;
        known += draw.weight;
        sum += draw.weight * draw.value;
        ++count;
    }
    if (count < 2 || 2.0 * known < all) return {kNotKnown, NotKnown::undefined};
    double squares = 0.0;
    for (const Weighed& draw : draws) {
        if (std::isnan(draw.value)) continue;
        const double off = draw.value - sum / known;
        squares += draw.weight * off * off;
    }
    const double error = std::sqrt(squares / known);
    if (error <= kStill) return {kNotKnown, NotKnown::still};
    return {error, NotKnown::known};
}

StandardError jackknife_error(std::span<const Weighed> without) {
    const auto is_undefined = [](const Weighed& one) { return std::isnan(one.value); };
    if (without.empty()) return {kNotKnown, NotKnown::one_person};
    if (std::ranges::any_of(without, is_undefined)) return {kNotKnown, NotKnown::undefined};
    StandardError error = bootstrap_error(without);
    error.value *= std::sqrt(static_cast<double>(without.size()) - 1.0);
    return error;
}

StandardError two_way_error(const StandardError& both, const StandardError& one,
                            const StandardError& other) {
    if (both.why != NotKnown::known) return both;
    const auto square = [](const StandardError& error) {
        return error.why == NotKnown::known ? error.value * error.value : 0.0;
    };
    const double most = square(both);
    const double least = std::min(most, std::max(square(one), square(other)));
    const double variance = std::clamp(2.0 * (square(one) + square(other)) - most, least, most);
    return {std::sqrt(variance), NotKnown::known};
}

Interval interval_about(double value, double error, double coverage, std::size_t freedom,
                        Interval limits) {
    if (std::isnan(value) || std::isnan(error)) return {kNotKnown, kNotKnown};
    const double reach = error * two_sided_quantile(coverage, freedom);
    return {std::max(value - reach, limits.low), std::min(value + reach, limits.high)};
}

}  // namespace tact
