#include "devices/two_band_tracking.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "model/range.h"
#include "model/spectrum.h"

namespace tact {

namespace {

constexpr double kWindowS = 0.05;
constexpr double kLongWindowS = 0.1;  // where tones are close and steady
constexpr double kSilenceBlockS = 0.005;
constexpr double kSilence = 0.02;       // of the loudest block under the window
constexpr double kShortestFitS = 0.01;  // anything shorter is a click, told by its peak
constexpr double kWeakestFar = 0.05;    // of the first tone's amplitude, for a tone beside it ...
constexpr double kWeakestNear = 0.15;   // ... within the window's main lobe
constexpr double kWellFitted = 0.003;   // share left: there is nothing to look for any more
constexpr double kSteadyEnough = 0.05;  // share that a long window may leave
constexpr double kNoiseFrom = 0.5;      // share lost by two sines
constexpr double kFoldedHz = 160.0;
constexpr double kLowAloneBelowHz = 200.0;  // a single tone below goes to the low band

struct Tone {
    double frequency_hz = 0.0;
    double cosine = 0.0;
    double sine = 0.0;

    double amplitude() const { return std::hypot(cosine, sine); }
    double at(double t_s) const {
        const double angle = 2.0 * std::numbers::pi * frequency_hz * t_s;
        return cosine * std::cos(angle) + sine * std::sin(angle);
    }
};

// The signal around a moment: what of it counts, and how much.
struct View {
    double rate_hz = kModelRateHz;
    double first_s = 0.0;         // time of sample 0, from the middle of the frame
    std::vector<double> samples;  // zero beyond the signal's ends
    std::vector<double> weights;  // Hann; zero where it is silent

    double time_s(std::size_t n) const { return first_s + static_cast<double>(n) / rate_hz; }
};

struct Fit {
    std::vector<Tone> tones;
    double share_left = 1.0;  // of the weighted energy
};

double energy_of(const View& view, std::span<const double> signal) {
    double sum = 0.0;
    for (std::size_t n = 0; n < signal.size(); ++n) {
        sum += view.weights[n] * signal[n] * signal[n];
    }
    return sum;
}

Eigen::Map<const Eigen::VectorXd> column(const std::vector<double>& values) {
    return {values.data(), std::ssize(values)};
}

// Two columns a tone, its cosine and its sine: each sample a rotation of the one before.
Eigen::MatrixXd quadratures(const View& view, std::span<const Tone> tones) {
    Eigen::MatrixXd columns(std::ssize(view.samples), 2 * std::ssize(tones));
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const double omega = 2.0 * std::numbers::pi * tones[i].frequency_hz;
        const auto at = static_cast<Eigen::Index>(2 * i);
        const double c = std::cos(omega / view.rate_hz);
        const double s = std::sin(omega / view.rate_hz);
        double x = std::cos(omega * view.first_s);
        double y = std::sin(omega * view.first_s);
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
Eigen::VectorXd solved(const View& view, const Eigen::MatrixXd& columns,
                       const Eigen::VectorXd& signal) {
    const Eigen::MatrixXd weighted = column(view.weights).asDiagonal() * columns;
    const Eigen::MatrixXd normal = weighted.transpose() * columns;
    const Eigen::VectorXd best = normal.ldlt().solve(weighted.transpose() * signal);
    return best.allFinite() ? best : Eigen::VectorXd::Zero(columns.cols());
}

// The columns and d/df of each tone, which is t times the tone a quarter turn on.
Eigen::MatrixXd with_derivatives(const View& view, const Eigen::MatrixXd& columns,
                                 const Eigen::VectorXd& best) {
    const Eigen::Index tones = columns.cols() / 2;
    Eigen::MatrixXd all(columns.rows(), 3 * tones);
    all.leftCols(2 * tones) = columns;
    for (Eigen::Index i = 0; i < tones; ++i) {
        for (Eigen::Index n = 0; n < columns.rows(); ++n) {
            const double t_s = view.time_s(static_cast<std::size_t>(n));
            all(n, 2 * tones + i) =
                2.0 * std::numbers::pi * t_s *
                (best[2 * i + 1] * columns(n, 2 * i) - best[2 * i] * columns(n, 2 * i + 1));
        }
    }
    return all;
}

// What the tones leave of the signal.
std::vector<double> without(const View& view, std::span<const Tone> tones) {
    std::vector<double> rest = view.samples;
    const Eigen::MatrixXd columns = quadratures(view, tones);
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(2 * i);
        for (std::size_t n = 0; n < rest.size(); ++n) {
            const auto row = static_cast<Eigen::Index>(n);
            rest[n] -= tones[i].cosine * columns(row, at) + tones[i].sine * columns(row, at + 1);
        }
    }
    return rest;
}

double share_left_by(const View& view, std::span<const Tone> tones) {
    const double whole = energy_of(view, view.samples);
    if (!(whole > 0.0)) return 0.0;
    return std::min(1.0, energy_of(view, without(view, tones)) / whole);
}

// Gauss-Newton on all frequencies at once, from where they are.
Fit refined(const View& view, std::vector<Tone> tones, double farthest_step_hz) {
    constexpr int kMostSteps = 10;
    constexpr double kStillHz = 1e-2;
    const double whole = energy_of(view, view.samples);
    Fit best{tones, 2.0};
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::MatrixXd columns = quadratures(view, tones);
        const Eigen::VectorXd linear = solved(view, columns, column(view.samples));
        for (std::size_t i = 0; i < tones.size(); ++i) {
            tones[i].cosine = linear[static_cast<Eigen::Index>(2 * i)];
            tones[i].sine = linear[static_cast<Eigen::Index>(2 * i + 1)];
        }
        const Eigen::VectorXd rest = column(view.samples) - columns * linear;
        const double left = rest.cwiseAbs2().dot(column(view.weights)) / whole;
        if (left < best.share_left) best = {tones, left};
        const Eigen::VectorXd moves =
            solved(view, with_derivatives(view, columns, linear), rest).tail(std::ssize(tones));
        if (moves.cwiseAbs().maxCoeff() < kStillHz) break;
        for (std::size_t i = 0; i < tones.size(); ++i) {
            const double move = std::clamp(moves[static_cast<Eigen::Index>(i)], -farthest_step_hz,
                                           farthest_step_hz);
            tones[i].frequency_hz =
                std::clamp(tones[i].frequency_hz + move, kLowestHz, kHighestHighBandHz);
        }
    }
    return best;
}

Spectrum windowed_spectrum(const View& view, std::span<const double> signal) {
    std::size_t length = 1;
    while (length < 4 * signal.size()) length *= 2;
    std::vector<double> windowed(length, 0.0);
    for (std::size_t n = 0; n < signal.size(); ++n) windowed[n] = view.weights[n] * signal[n];
    return amplitude_spectrum(windowed, view.rate_hz);
}

// The strongest sine of a signal, near enough to be refined; none in silence.
std::optional<Tone> strongest(const View& view, std::span<const double> signal) {
    const Spectrum spectrum = windowed_spectrum(view, signal);
    std::size_t peak = 0;
    for (std::size_t k = 1; k < spectrum.amplitude_g.size(); ++k) {
        const double at_hz = frequency_hz(spectrum, k);
        if (at_hz < kLowestHz || at_hz > kHighestHighBandHz) continue;
        if (spectrum.amplitude_g[k] > spectrum.amplitude_g[peak] || peak == 0) peak = k;
    }
    if (peak == 0 || !(spectrum.amplitude_g[peak] > 0.0)) return {};
    double weights = 0.0;
    for (const double weight : view.weights) weights += weight;
    const auto length = static_cast<double>(spectrum.samples);
    return Tone{frequency_hz(spectrum, peak), spectrum.amplitude_g[peak] * length / weights, 0.0};
}

double apart_hz(const Tone& a, const Tone& b) { return std::abs(a.frequency_hz - b.frequency_hz); }

// Whether what a fit leaves has a tone of its own at its peak: a glide or a ramp leaves something
// near the tone that glides.
bool is_tone(const Tone& peak, const Fit& fit, double window_s) {
    double share = kWeakestFar;
    double first = 0.0;
    for (const Tone& tone : fit.tones) {
        first = std::max(first, tone.amplitude());
        if (apart_hz(peak, tone) < 2.0 / window_s) share = kWeakestNear;
    }
    return peak.amplitude() >= share * first;
}

bool are_apart(const Fit& fit, double window_s) {
    const double least_hz = kLeastApartHz * kLongWindowS / window_s;
    for (std::size_t i = 0; i < fit.tones.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (apart_hz(fit.tones[i], fit.tones[j]) < least_hz) return false;
        }
    }
    return true;
}

// The fit with the strongest tone that it leaves, all refined together; itself where there is none.
Fit with_one_more(const View& view, const Fit& fit, double window_s) {
    const auto peak = strongest(view, without(view, fit.tones));
    if (!peak || !is_tone(*peak, fit, window_s)) return fit;
    std::vector<Tone> tones = fit.tones;
    tones.push_back(*peak);
    Fit more = refined(view, std::move(tones), 0.5 / window_s);
    return are_apart(more, window_s) && more.share_left < fit.share_left ? more : fit;
}

// One sine, or the two strongest of up to three: a third would bend the two if it were not fitted
// along with them. By frequency.
Fit fitted(const View& view, double window_s) {
    const std::optional<Tone> first = strongest(view, view.samples);
    if (!first) return {{}, 0.0};
    Fit fit = with_one_more(view, refined(view, {*first}, 0.5 / window_s), window_s);
    if (fit.tones.size() == 2 && fit.share_left > kWellFitted) {
        fit = with_one_more(view, fit, window_s);
    }
    if (fit.tones.size() == 3) {
        std::ranges::sort(fit.tones, std::greater<>(), &Tone::amplitude);
        fit.tones.pop_back();
        fit.share_left = share_left_by(view, fit.tones);
    }
    std::ranges::sort(fit.tones, {}, &Tone::frequency_hz);
    return fit;
}

// Weight zero for what is silent, and for what a silence parts from the frame itself.
void leave_out_silence(View& view, double half_hop_s) {
    const auto block = static_cast<std::size_t>(std::lround(kSilenceBlockS * view.rate_hz));
    const std::size_t blocks = (view.samples.size() + block - 1) / block;
    const std::size_t size = view.samples.size();
    std::vector<double> peaks(blocks, 0.0);
    for (std::size_t n = 0; n < size; ++n) {
        peaks[n / block] = std::max(peaks[n / block], std::abs(view.samples[n]));
    }
    const double threshold = kSilence * *std::ranges::max_element(peaks);
    const auto is_silent = [&](std::size_t b) { return b >= blocks || peaks[b] <= threshold; };
    for (std::size_t b = 0; b < blocks;) {
        std::size_t end = b;
        while (end < blocks && !is_silent(end)) ++end;
        // The note from block b to block `end`, to the sample.
        std::size_t from = b * block;
        std::size_t to = std::min(end * block, size);
        while (from < to && std::abs(view.samples[from]) <= threshold) ++from;
        while (to > from && std::abs(view.samples[to - 1]) <= threshold) --to;
        const bool in_frame =
            from < to && view.time_s(from) < half_hop_s && view.time_s(to - 1) >= -half_hop_s;
        for (std::size_t n = b * block; n < std::min((end + 1) * block, size); ++n) {
            if (!in_frame || n < from || n >= to) view.weights[n] = 0.0;
        }
        b = end + 1;
    }
}

View view_around(const Drive& drive, double middle_s, double window_s, double hop_s) {
    View view;
    view.rate_hz = drive.rate_hz;
    const auto count = static_cast<std::ptrdiff_t>(std::lround(window_s * drive.rate_hz));
    const auto first =
        static_cast<std::ptrdiff_t>(std::lround(middle_s * drive.rate_hz)) - count / 2;
    view.first_s = static_cast<double>(first) / drive.rate_hz - middle_s;
    for (std::ptrdiff_t n = 0; n < count; ++n) {
        const std::ptrdiff_t at = first + n;
        const bool inside = at >= 0 && at < std::ssize(drive.samples);
        view.samples.push_back(inside ? drive.samples[static_cast<std::size_t>(at)] : 0.0);
        const double turn = (static_cast<double>(n) + 0.5) / static_cast<double>(count);
        view.weights.push_back(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn));
    }
    leave_out_silence(view, hop_s / 2.0);
    return view;
}

double largest_in_hop(const View& view, double hop_s, const std::optional<Tone>& of) {
    double largest = 0.0;
    for (std::size_t n = 0; n < view.samples.size(); ++n) {
        const double t_s = view.time_s(n);
        if (std::abs(t_s) > hop_s / 2.0 || view.weights[n] <= 0.0) continue;
        largest = std::max(largest, std::abs(of ? of->at(t_s) : view.samples[n]));
    }
    return largest;
}

// Root of twice the mean square between two frequencies, at the centroid of the power there.
void put_noise_band(const Spectrum& spectrum, double weight, Range band_hz, double& at_hz,
                    double& amplitude) {
    double power = 0.0;
    double moment = 0.0;
    for (std::size_t k = 1; k < spectrum.amplitude_g.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        if (f_hz < band_hz.low || f_hz >= band_hz.high) continue;
        power += spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
        moment += f_hz * spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
    }
    if (!(power > 0.0)) return;
    at_hz = moment / power;
    amplitude = std::sqrt(power * weight);
}

RumbleFrame noise_frame(const View& view) {
    const Spectrum spectrum = windowed_spectrum(view, view.samples);
    double squares = 0.0;
    for (const double weight : view.weights) squares += weight * weight;
    // Parseval: the amplitudes' squares are those of the windowed, padded signal.
    const double weight = static_cast<double>(spectrum.samples) / squares;
    RumbleFrame frame;
    put_noise_band(spectrum, weight, {kLowestLowBandHz, kLowAloneBelowHz}, frame.low_hz, frame.low);
    put_noise_band(spectrum, weight, {kLowAloneBelowHz, kHighestLowBandHz}, frame.high_hz,
                   frame.high);
    return within_one_coil(frame);
}

// Half a step of the code beyond the band is still its last code.
bool is_below(double frequency_hz, double lowest_hz) { return frequency_hz < 0.989 * lowest_hz; }
bool is_above(double frequency_hz, double highest_hz) { return frequency_hz > 1.011 * highest_hz; }

// The tones in the bands that can carry them; `carried` are those that found a place.
RumbleFrame placed(std::vector<Tone> tones, std::vector<Tone>& carried) {
    RumbleFrame frame;
    const auto low = [&](const Tone& tone) {
        frame.low_hz = tone.frequency_hz;
        frame.low = tone.amplitude();
        carried.push_back(tone);
    };
    const auto high = [&](const Tone& tone) {
        frame.high_hz = tone.frequency_hz;
        frame.high = tone.amplitude();
        carried.push_back(tone);
    };
    if (tones.size() == 2) {
        const bool fit = !is_below(tones[1].frequency_hz, kLowestHighBandHz) &&
                         !is_above(tones[0].frequency_hz, kHighestLowBandHz);
        if (!fit) tones.erase(std::ranges::min_element(tones, {}, &Tone::amplitude));
    }
    if (tones.size() == 2) {
        low(tones[0]);
        high(tones[1]);
    } else if (tones.size() == 1) {
        tones[0].frequency_hz < kLowAloneBelowHz ? low(tones[0]) : high(tones[0]);
    }
    return within_one_coil(frame);
}

// A click is too short to have a frequency: its peak at the middle of its spectrum.
TrackedFrame click(const View& view, TrackedFrame frame, double hop_s) {
    const std::optional<Tone> tone = strongest(view, view.samples);
    frame.share_lost = 1.0;
    if (!tone) return frame;
    std::vector<Tone> none;
    Tone peak = *tone;
    peak.frequency_hz = std::max(peak.frequency_hz, kLowestLowBandHz);
    peak.cosine = largest_in_hop(view, hop_s, std::nullopt);
    frame.rumble = placed({peak}, none);
    frame.noise = true;
    return frame;
}

// The amplitude of a swell of 160 Hz that is the low tone's rectified course.
void fold(const View& view, std::vector<Tone>& tones, TrackedFrame& frame, double hop_s) {
    if (tones.empty() || !is_below(tones[0].frequency_hz, kLowestLowBandHz)) return;
    const double swell = largest_in_hop(view, hop_s, tones[0]);
    tones.erase(tones.begin());
    frame.folded = true;
    // Beside another tone in its band the fold takes the other one's place only if stronger.
    if (!tones.empty() && tones[0].frequency_hz < kLowAloneBelowHz) {
        if (tones[0].amplitude() >= swell) return;
        tones.clear();
    }
    frame.rumble.low = swell;
    frame.rumble.low_hz = kFoldedHz;
}

double share_of_time(const View& view, double hop_s) {
    std::size_t inside = 0;
    std::size_t sounding = 0;
    for (std::size_t n = 0; n < view.samples.size(); ++n) {
        if (std::abs(view.time_s(n)) > hop_s / 2.0) continue;
        ++inside;
        if (view.weights[n] > 0.0) ++sounding;
    }
    return inside == 0 ? 0.0 : static_cast<double>(sounding) / static_cast<double>(inside);
}

double sounding_s(const View& view) {
    const auto silent = std::ranges::count_if(view.weights, [](double w) { return w <= 0.0; });
    return static_cast<double>(std::ssize(view.weights) - silent) / view.rate_hz;
}

double mean_square(const View& view) {
    double weights = 0.0;
    for (const double weight : view.weights) weights += weight;
    return weights > 0.0 ? energy_of(view, view.samples) / weights : 0.0;
}

}  // namespace

std::size_t frame_count(const Drive& drive, double hop_s) {
    const auto samples = static_cast<double>(drive.samples.size());
    // A rounding error of the duration makes no frame of its own.
    return static_cast<std::size_t>(std::ceil(samples / (drive.rate_hz * hop_s) - 1e-6));
}

TrackedFrame tracked_frame(const Drive& drive, std::size_t k, double hop_s) {
    const double middle_s = (static_cast<double>(k) + 0.5) * hop_s;
    View view = view_around(drive, middle_s, kWindowS, hop_s);
    TrackedFrame frame;
    frame.energy = mean_square(view) * share_of_time(view, hop_s);
    if (!(frame.energy > 0.0)) return frame;
    if (sounding_s(view) < kShortestFitS) return click(view, frame, hop_s);
    Fit fit = fitted(view, kWindowS);
    if (fit.share_left > kWellFitted) {
        // Twice the time tells closer tones apart, where they are steady enough to show it.
        const View longer = view_around(drive, middle_s, kLongWindowS, hop_s);
        const Fit steady = fitted(longer, kLongWindowS);
        if (steady.share_left < std::min(fit.share_left / 2.0, kSteadyEnough)) {
            fit = steady;
            view = longer;
        }
    }
    frame.share_lost = fit.share_left;
    if (fit.share_left > kNoiseFrom) {
        frame.noise = true;
        frame.rumble = noise_frame(view);
        return frame;
    }
    std::vector<Tone> carried;
    fold(view, fit.tones, frame, hop_s);
    const RumbleFrame beside = frame.rumble;
    frame.rumble = placed(fit.tones, carried);
    if (frame.folded && beside.low > 0.0) {
        frame.rumble.low = beside.low;
        frame.rumble.low_hz = beside.low_hz;
        frame.rumble = within_one_coil(frame.rumble);
    }
    frame.share_lost = share_left_by(view, carried);
    return frame;
}

}  // namespace tact
