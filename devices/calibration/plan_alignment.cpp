#include "devices/calibration/plan_alignment.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <vector>

namespace tact {

namespace {

constexpr std::size_t kHopSamples = 100;  // 10 ms
constexpr std::size_t kHalfWindow = 5;    // hops
constexpr double kLeastAlike = 0.3;
constexpr double kNearly = 0.8;  // as much alike as the best: another play of the plan

double mean_of(std::span<const double> samples) {
    double sum = 0.0;
    for (const double sample : samples) sum += sample;
    return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

// How strong the samples are at a frequency in a window around each hop.
std::vector<double> strength_over_time(std::span<const double> samples, double f_hz,
                                       double rate_hz) {
    const double offset = mean_of(samples);
    const std::size_t hops = samples.size() / kHopSamples;
    const double turn = 2.0 * std::numbers::pi * f_hz / rate_hz;
    std::vector<std::complex<double>> turns(kHopSamples);
    for (std::size_t n = 0; n < kHopSamples; ++n) {
        turns[n] = std::polar(1.0, -turn * static_cast<double>(n));
    }
    std::vector<std::complex<double>> until(hops + 1);
    for (std::size_t k = 0; k < hops; ++k) {
        const std::size_t first = k * kHopSamples;
        double re = 0.0;
        double im = 0.0;
        for (std::size_t n = 0; n < kHopSamples; ++n) {
            re += (samples[first + n] - offset) * turns[n].real();
            im += (samples[first + n] - offset) * turns[n].imag();
        }
        const double phase = -turn * static_cast<double>(first);
        until[k + 1] = until[k] + std::complex(re, im) * std::polar(1.0, phase);
    }
    std::vector<double> strengths(hops);
    for (std::size_t k = 0; k < hops; ++k) {
        const std::size_t begin = k - std::min(k, kHalfWindow);
        const std::size_t end = std::min(hops, k + kHalfWindow);
        strengths[k] = std::abs(until[end] - until[begin]);
    }
    return strengths;
}

// Values and squares summed up to each place.
struct Sums {
    std::vector<double> values{0.0};
    std::vector<double> squares{0.0};

    explicit Sums(std::span<const double> of) {
        for (const double value : of) {
            values.push_back(values.back() + value);
            squares.push_back(squares.back() + value * value);
        }
    }
    // n times the variance.
    double spread(std::size_t from, std::size_t count) const {
        const double sum = values[from + count] - values[from];
        return squares[from + count] - squares[from] - sum * sum / static_cast<double>(count);
    }
};

// Adds Pearson's correlation with `found` from every lag on. What is below a twentieth of the
// strongest is other frequencies' leakage, and counts as nothing.
void add_correlations(std::span<const double> meant, std::span<const double> found,
                      std::vector<double>& alike) {
    const double least = 0.05 * std::ranges::max(meant);
    std::vector<double> kept(meant.begin(), meant.end());
    for (double& value : kept) value = value < least ? 0.0 : value;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (kept[k] > 0.0) places.push_back(k);
    }
    const Sums of_meant(kept);
    const Sums of_found(found);
    const double whole = of_found.squares.back();
    for (std::size_t lag = 0; lag < alike.size(); ++lag) {
        double both = 0.0;
        for (const std::size_t k : places) both += kept[k] * found[lag + k];
        const double sum = of_found.values[lag + kept.size()] - of_found.values[lag];
        both -= of_meant.values.back() * sum / static_cast<double>(kept.size());
        const double found_spread = of_found.spread(lag, kept.size());
        if (found_spread <= 1e-12 * whole) continue;  // nothing but rounding
        alike[lag] += both / std::sqrt(of_meant.spread(0, kept.size()) * found_spread);
    }
}

}  // namespace

namespace {

struct Likeness {
    double share = 0.0;  // mean over the frequencies
    std::size_t lag = 0;
};

// What the plan would be to a clock that is off.
std::vector<double> quickened(const std::vector<double>& strengths, double clock_off) {
    std::vector<double> quick;
    for (std::size_t k = 0;; ++k) {
        const double at = static_cast<double>(k) * (1.0 + clock_off);
        const auto below = static_cast<std::size_t>(at);
        if (below + 1 >= strengths.size()) return quick;
        const double share = at - static_cast<double>(below);
        quick.push_back(strengths[below] + share * (strengths[below + 1] - strengths[below]));
    }
}

// Likeness over every `step`th frequency of the plan.
Likeness likeness(const CalibrationPlan& plan, std::span<const double> samples, double clock_off,
                  std::size_t step) {
    const std::vector<double>& drive = plan.drive.samples;
    std::set<double> all_hz;
    for (const CalibrationTone& tone : plan.tones) all_hz.insert(tone.frequency_hz);
    const auto fits =
        static_cast<std::size_t>(static_cast<double>(drive.size()) / (1.0 + clock_off));
    if (all_hz.empty() || samples.size() + kHopSamples < fits) return {};
    std::vector<double> alike(
        1 + samples.size() / kHopSamples - std::min(samples.size(), fits) / kHopSamples, 0.0);
    std::size_t counted = 0;
    std::size_t place = 0;
    for (const double f_hz : all_hz) {
        if (place++ % step != 0) continue;
        ++counted;
        const std::vector<double> meant =
            quickened(strength_over_time(drive, f_hz, plan.drive.rate_hz), clock_off);
        std::vector<double> found =
            strength_over_time(samples, f_hz * (1.0 + clock_off), plan.drive.rate_hz);
        found.resize(std::max(found.size(), meant.size() + alike.size()), 0.0);
        add_correlations(meant, found, alike);
    }
    const auto best = std::ranges::max_element(alike);
    return {*best / static_cast<double>(counted), static_cast<std::size_t>(best - alike.begin())};
}

}  // namespace

double clock_off_of(const CalibrationPlan& plan, std::span<const double> samples) {
    constexpr std::size_t kSome = 4;  // of the frequencies
    constexpr double kStep = 0.002;
    constexpr double kClearly = 1e-3;  // by less a clock is no better
    const auto alike = [&](double off) { return likeness(plan, samples, off, kSome).share; };
    double best = 0.0;
    double most = alike(0.0);
    for (const double direction : {1.0, -1.0}) {
        double at = 0.0;
        // One that is much too fast or slow has a valley before it.
        for (int ahead = 1;
             ahead <= 3 && std::abs(at + direction * kStep * ahead) <= kMostClockOff;) {
            const double off = at + direction * kStep * ahead;
            const double found = alike(off);
            if (found > most + kClearly) {
                best = at = off;
                most = found;
                ahead = 1;
            } else {
                ++ahead;
            }
        }
        if (best != 0.0) break;
    }
    if (best == 0.0) return 0.0;
    // The top of a parabola through three.
    const double before = alike(best - kStep);
    const double after = alike(best + kStep);
    const double bend = before - 2.0 * most + after;
    return bend < 0.0 ? best + 0.5 * kStep * (before - after) / bend : best;
}

std::optional<std::size_t> place_of_plan(const CalibrationPlan& plan,
                                         std::span<const double> samples, bool latest) {
    const std::vector<double>& drive = plan.drive.samples;
    std::set<double> frequencies_hz;
    for (const CalibrationTone& tone : plan.tones) frequencies_hz.insert(tone.frequency_hz);
    if (frequencies_hz.empty() || samples.size() < drive.size()) return std::nullopt;
    std::vector<double> alike(1 + samples.size() / kHopSamples - drive.size() / kHopSamples, 0.0);
    for (const double f_hz : frequencies_hz) {
        add_correlations(strength_over_time(drive, f_hz, plan.drive.rate_hz),
                         strength_over_time(samples, f_hz, plan.drive.rate_hz), alike);
    }
    auto best = std::ranges::max_element(alike);
    if (*best < kLeastAlike * static_cast<double>(frequencies_hz.size())) return std::nullopt;
    if (latest) {
        const double nearly = kNearly * *best;
        auto last = alike.end() - 1;
        while (*last < nearly) --last;
        while (last != alike.begin() && *(last - 1) >= *last) --last;
        best = last;
    }
    return static_cast<std::size_t>(best - alike.begin()) * kHopSamples;
}

}  // namespace tact
