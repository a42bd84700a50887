#include "devices/rumble/sine_fit.h"

#include <algorithm>
#include <functional>

#include "model/common/decompositions.h"

namespace tact {

namespace {

// For a tone beside a stronger one, of its amplitude: anywhere, and within the window's main lobe.
constexpr double kWeakestFar = 0.05;
constexpr double kWeakestNear = 0.15;

double energy_in(const Stretch& stretch, std::span<const double> signal) {
    double sum = 0.0;
    for (std::size_t n = 0; n < signal.size(); ++n) {
        sum += stretch.weights[n] * signal[n] * signal[n];
    }
    return sum;
}

Eigen::Map<const Eigen::VectorXd> column(const std::vector<double>& values) {
    return {values.data(), std::ssize(values)};
}

// Two columns a tone, its cosine and its sine: each sample a rotation of the one before.
Eigen::MatrixXd quadratures(const Stretch& stretch, std::span<const Tone> tones) {
    Eigen::MatrixXd columns(std::ssize(stretch.samples), 2 * std::ssize(tones));
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const double omega = 2.0 * std::numbers::pi * tones[i].frequency_hz;
        const auto at = static_cast<Eigen::Index>(2 * i);
        const double c = std::cos(omega / stretch.rate_hz);
        const double s = std::sin(omega / stretch.rate_hz);
        double x = std::cos(omega * stretch.first_s);
        double y = std::sin(omega * stretch.first_s);
        for (Eigen::Index n = 0; n < columns.rows(); ++n) {
            columns(n, at) = x;
            columns(n, at + 1) = y;
            const double turned = c * x - s * y;
            y = s * x + c * y;
            x = turned;
        }
    }
    return columns;
}

// Weighted least squares; zeros where the columns are too alike to be told apart.
Eigen::VectorXd solved(const Stretch& stretch, const Eigen::MatrixXd& columns,
                       const Eigen::VectorXd& signal) {
    const Eigen::MatrixXd weighted = column(stretch.weights).asDiagonal() * columns;
    const Eigen::MatrixXd normal = weighted.transpose() * columns;
    const Eigen::VectorXd best = solved_symmetric(normal, weighted.transpose() * signal);
    return best.allFinite() ? best : Eigen::VectorXd::Zero(columns.cols());
}

// The columns and d/df of each tone, which is t times the tone a quarter turn on.
Eigen::MatrixXd with_derivatives(const Stretch& stretch, const Eigen::MatrixXd& columns,
                                 const Eigen::VectorXd& best) {
    const Eigen::Index tones = columns.cols() / 2;
    Eigen::MatrixXd all(columns.rows(), 3 * tones);
    all.leftCols(2 * tones) = columns;
    for (Eigen::Index i = 0; i < tones; ++i) {
        for (Eigen::Index n = 0; n < columns.rows(); ++n) {
            const double t_s = stretch.time_s(static_cast<std::size_t>(n));
            all(n, 2 * tones + i) =
                2.0 * std::numbers::pi * t_s *
                (best[2 * i + 1] * columns(n, 2 * i) - best[2 * i] * columns(n, 2 * i + 1));
        }
    }
    return all;
}

// What the tones leave of the signal.
std::vector<double> without(const Stretch& stretch, std::span<const Tone> tones) {
    std::vector<double> rest = stretch.samples;
    const Eigen::MatrixXd columns = quadratures(stretch, tones);
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(2 * i);
        for (std::size_t n = 0; n < rest.size(); ++n) {
            const auto row = static_cast<Eigen::Index>(n);
            rest[n] -= tones[i].cosine * columns(row, at) + tones[i].sine * columns(row, at + 1);
        }
    }
    return rest;
}

// Gauss-Newton on all frequencies at once, from where they are.
SineFit refined(const Stretch& stretch, std::vector<Tone> tones, double farthest_step_hz) {
    constexpr int kMostSteps = 10;
    constexpr double kStillHz = 1e-2;
    const double whole = energy_in(stretch, stretch.samples);
    SineFit best{tones, 2.0};
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::MatrixXd columns = quadratures(stretch, tones);
        const Eigen::VectorXd linear = solved(stretch, columns, column(stretch.samples));
        for (std::size_t i = 0; i < tones.size(); ++i) {
            tones[i].cosine = linear[static_cast<Eigen::Index>(2 * i)];
            tones[i].sine = linear[static_cast<Eigen::Index>(2 * i + 1)];
        }
        const Eigen::VectorXd rest = column(stretch.samples) - columns * linear;
        const double left = rest.cwiseAbs2().dot(column(stretch.weights)) / whole;
        if (left < best.share_left) best = {tones, left};
        const Eigen::VectorXd moves =
            solved(stretch, with_derivatives(stretch, columns, linear), rest)
                .tail(std::ssize(tones));
        if (moves.cwiseAbs().maxCoeff() < kStillHz) break;
        for (std::size_t i = 0; i < tones.size(); ++i) {
            const double move = std::clamp(moves[static_cast<Eigen::Index>(i)], -farthest_step_hz,
                                           farthest_step_hz);
            tones[i].frequency_hz =
                std::clamp(tones[i].frequency_hz + move, kToneHz.low, kToneHz.high);
        }
    }
    return best;
}

Spectrum spectrum_of(const Stretch& stretch, std::span<const double> signal) {
    std::size_t length = 1;
    while (length < 4 * signal.size()) length *= 2;
    std::vector<double> windowed(length, 0.0);
    for (std::size_t n = 0; n < signal.size(); ++n) windowed[n] = stretch.weights[n] * signal[n];
    return amplitude_spectrum(windowed, stretch.rate_hz);
}

// The strongest sine of a signal, near enough to be refined; none in silence.
std::optional<Tone> strongest(const Stretch& stretch, std::span<const double> signal) {
    const Spectrum spectrum = spectrum_of(stretch, signal);
    std::size_t peak = 0;
    for (std::size_t k = 1; k < spectrum.amplitude_g.size(); ++k) {
        const double at_hz = frequency_hz(spectrum, k);
        if (!kToneHz.contains(at_hz)) continue;
        if (spectrum.amplitude_g[k] > spectrum.amplitude_g[peak] || peak == 0) peak = k;
    }
    if (peak == 0 || !(spectrum.amplitude_g[peak] > 0.0)) return {};
    double weights = 0.0;
    for (const double weight : stretch.weights) weights += weight;
    const auto length = static_cast<double>(spectrum.samples);
    return Tone{frequency_hz(spectrum, peak), spectrum.amplitude_g[peak] * length / weights, 0.0};
}

double apart_hz(const Tone& a, const Tone& b) { return std::abs(a.frequency_hz - b.frequency_hz); }

// Whether what a fit leaves has a tone of its own at its peak: a glide or a ramp leaves something
// near the tone that glides.
bool is_tone(const Tone& peak, const SineFit& fit, double window_s) {
    double share = kWeakestFar;
    double first = 0.0;
    for (const Tone& tone : fit.tones) {
        first = std::max(first, tone.amplitude());
        if (apart_hz(peak, tone) < 2.0 / window_s) share = kWeakestNear;
    }
    return peak.amplitude() >= share * first;
}

bool are_apart(const SineFit& fit, double window_s) {
    const double least_hz = kLeastApartHz * kLongWindowS / window_s;
    for (std::size_t i = 0; i < fit.tones.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (apart_hz(fit.tones[i], fit.tones[j]) < least_hz) return false;
        }
    }
    return true;
}

// The fit with the strongest tone that it leaves, all refined together; the fit itself if no tone
// is left.
SineFit with_one_more(const Stretch& stretch, const SineFit& fit, double window_s) {
    const auto peak = strongest(stretch, without(stretch, fit.tones));
    if (!peak || !is_tone(*peak, fit, window_s)) return fit;
    std::vector<Tone> tones = fit.tones;
    tones.push_back(*peak);
    SineFit more = refined(stretch, std::move(tones), 0.5 / window_s);
    return are_apart(more, window_s) && more.share_left < fit.share_left ? more : fit;
}

}  // namespace

double energy_of(const Stretch& stretch) { return energy_in(stretch, stretch.samples); }

double share_left_by(const Stretch& stretch, std::span<const Tone> tones) {
    const double whole = energy_in(stretch, stretch.samples);
    if (!(whole > 0.0)) return 0.0;
    return std::min(1.0, energy_in(stretch, without(stretch, tones)) / whole);
}

std::optional<Tone> strongest_tone(const Stretch& stretch) {
    return strongest(stretch, stretch.samples);
}

Spectrum weighted_spectrum(const Stretch& stretch) { return spectrum_of(stretch, stretch.samples); }

// One sine, or the two strongest of up to three: a third would bend the two if it were not fitted
// along with them. By frequency.
SineFit fitted_sines(const Stretch& stretch, double window_s) {
    const std::optional<Tone> first = strongest(stretch, stretch.samples);
    if (!first) return {{}, 0.0};
    SineFit fit = with_one_more(stretch, refined(stretch, {*first}, 0.5 / window_s), window_s);
    if (fit.tones.size() == 2 && fit.share_left > kWellFitted) {
        fit = with_one_more(stretch, fit, window_s);
    }
    if (fit.tones.size() == 3) {
        std::ranges::sort(fit.tones, std::greater<>(), &Tone::amplitude);
        fit.tones.pop_back();
        fit.share_left = share_left_by(stretch, fit.tones);
    }
    std::ranges::sort(fit.tones, {}, &Tone::frequency_hz);
    return fit;
}

}  // namespace tact
