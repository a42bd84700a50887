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

std::optional<std::size_t> place_of_plan(const CalibrationPlan& plan,
                                         std::span<const double> samples) {
    const std::vector<double>& drive = plan.drive.samples;
    std::set<double> frequencies_hz;
    for (const CalibrationTone& tone : plan.tones) frequencies_hz.insert(tone.frequency_hz);
    if (frequencies_hz.empty() || samples.size() < drive.size()) return std::nullopt;
    std::vector<double> alike(1 + samples.size() / kHopSamples - drive.size() / kHopSamples, 0.0);
    for (const double f_hz : frequencies_hz) {
        add_correlations(strength_over_time(drive, f_hz, plan.drive.rate_hz),
                         strength_over_time(samples, f_hz, plan.drive.rate_hz), alike);
    }
    const auto best = std::ranges::max_element(alike);
    if (*best < kLeastAlike * static_cast<double>(frequencies_hz.size())) return std::nullopt;
    return static_cast<std::size_t>(best - alike.begin()) * kHopSamples;
}

}  // namespace tact
