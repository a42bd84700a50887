#include "model/signal/pink_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"
#include "model/common/random.h"

namespace tact {

namespace {

constexpr double kLowestHz = 10.0;
constexpr double kSeamS = 0.5;    // over which the end fades into what came before the start
constexpr double kSettleS = 1.0;  // until the slowest filter has forgotten its start

// (1 - zero / z) / (1 - pole / z), each matched to its frequency.
void filter_one(std::vector<double>& samples, double zero, double pole) {
    double last_in = 0.0;
    double last_out = 0.0;
    for (double& sample : samples) {
        last_out = sample - zero * last_in + pole * last_out;
        last_in = sample;
        sample = last_out;
    }
}

void make_pink(std::vector<double>& samples, double rate_hz) {
    const auto matched = [rate_hz](double hz) {
        return portable::exp(-2.0 * std::numbers::pi * hz / rate_hz);
    };
    for (double pole_hz = kLowestHz; pole_hz < 0.5 * rate_hz; pole_hz *= 2.0) {
        filter_one(samples, matched(pole_hz * std::numbers::sqrt2), matched(pole_hz));
    }
}

}  // namespace

std::vector<double> pink_noise(double rate_hz, double seconds, std::uint64_t seed) {
    if (!(rate_hz > 0.0) || !(seconds > 0.0)) return {};
    const auto count = static_cast<std::size_t>(std::lround(seconds * rate_hz));
    const auto settle = static_cast<std::size_t>(std::lround(kSettleS * rate_hz));
    const std::size_t seam =
        std::min(count, static_cast<std::size_t>(std::lround(kSeamS * rate_hz)));
    RandomStream random{seed};
    std::vector<double> all(settle + seam + count);
    for (double& sample : all) sample = next_normal(random);
    make_pink(all, rate_hz);
    // The last stretch fades into the one before the first sample, at equal power as the two are
    // not alike.
    std::vector<double> loop(all.end() - static_cast<std::ptrdiff_t>(count), all.end());
    for (std::size_t k = 0; k < seam; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(seam);
        const double turn = 0.5 * std::numbers::pi * share;
        double& sample = loop[count - seam + k];
        sample = portable::cos(turn) * sample + portable::sin(turn) * all[settle + k];
    }
    double largest = 0.0;
    for (const double sample : loop) largest = std::max(largest, std::abs(sample));
    if (largest > 0.0) {
        for (double& sample : loop) sample /= largest;
    }
    return loop;
}

}  // namespace tact
