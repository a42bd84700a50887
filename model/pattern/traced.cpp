#include "model/pattern/traced.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/common/portable.h"
#include "model/signal/spectrum.h"
#include "model/signal/thinning.h"

namespace tact {

namespace {

constexpr double kEnvelopeS = 0.010;
constexpr double kEnvelopeStepS = 0.002;
constexpr double kSpectrumS = 0.040;
constexpr double kSpectrumStepS = 0.010;
constexpr Range kTracedHz{20.0, 1000.0};
constexpr std::size_t kFewestSamples = 8;  // a sine and a constant, twice over
constexpr double kEnergyFloor = 0.05;  // of the largest amplitude: what is less has no frequency

struct Track {
    std::vector<double> times_s;
    std::vector<double> heights;

    void add(double time_s, double height) {
        times_s.push_back(time_s);
        heights.push_back(height);
    }
};

// Times 0, step, 2 step, ... and the end.
std::vector<double> times_through(double length_s, double step_s) {
    std::vector<double> times_s;
    for (std::size_t k = 0; static_cast<double>(k) * step_s < length_s; ++k) {
        times_s.push_back(static_cast<double>(k) * step_s);
    }
    times_s.push_back(length_s);
    return times_s;
}

// The peak between 20 and 1000 Hz; none in silence.
std::optional<double> strongest_hz(std::span<const double> samples, double rate_hz) {
    const Spectrum spectrum = amplitude_spectrum(samples, rate_hz);
    const std::vector<double>& level = spectrum.amplitude_g;
    std::size_t peak = 0;
    for (std::size_t k = 1; k + 1 < level.size(); ++k) {
        if (!kTracedHz.contains(frequency_hz(spectrum, k))) continue;
        if (level[k] > 0.0 && (peak == 0 || level[k] > level[peak])) peak = k;
    }
    if (peak == 0) return std::nullopt;
    const double own_hz = frequency_hz(spectrum, peak);
    const double below = level[peak - 1];
    const double above = level[peak + 1];
    if (!(below > 0.0 && above > 0.0)) return own_hz;
    // The top of the parabola through (-1, a), (0, b), (1, c): (a - c) / (2 (a - 2 b + c)).
    const double a = portable::log(below);
    const double b = portable::log(level[peak]);
    const double c = portable::log(above);
    const double bend = a - 2.0 * b + c;
    if (!(bend < 0.0)) return own_hz;
    const double bins = std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
    return own_hz + bins * rate_hz / static_cast<double>(spectrum.samples);
}

std::vector<double> hann_windowed(std::span<const double> samples) {
    std::vector<double> windowed = without_mean(samples);
    const double turn = 2.0 * std::numbers::pi / static_cast<double>(windowed.size());
    for (std::size_t n = 0; n < windowed.size(); ++n) {
        windowed[n] *= 0.5 - 0.5 * portable::cos(turn * (static_cast<double>(n) + 0.5));
    }
    return windowed;
}

// The duration, s, of the half cycles in 10 ms, rounded up except for rounding errors. A shorter
// recording gives as many as it holds, and one of less than a half cycle its whole duration.
double whole_half_cycles_s(double frequency_hz, double longest_s) {
    constexpr double kRounding = 1e-3;
    const double wanted = std::ceil(2.0 * frequency_hz * kEnvelopeS - kRounding);
    const double held = std::floor(2.0 * frequency_hz * longest_s + kRounding);
    const double count = std::min(wanted, held);
    return count < 1.0 ? longest_s : count / (2.0 * frequency_hz);
}

// How much of the energy a sine of this frequency explains, beside a constant: least squares.
double explained_by(std::span<const double> x, double rate_hz, double frequency_hz) {
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d with_x = Eigen::Vector3d::Zero();
    const double turn = 2.0 * std::numbers::pi * frequency_hz / rate_hz;
    for (std::size_t n = 0; n < x.size(); ++n) {
        const double phase = turn * (static_cast<double>(n) - 0.5 * static_cast<double>(x.size()));
        const Eigen::Vector3d base{portable::cos(phase), portable::sin(phase), 1.0};
        products += base * base.transpose();
        with_x += base * x[n];
    }
    return with_x.dot(products.ldlt().solve(with_x));
}

// Where no window fits: the one sine that explains most of a recording too short for a spectrum.
std::optional<double> guessed_hz(std::span<const double> x, double rate_hz) {
    constexpr double kLeastCycles = 0.75;  // of fewer, a constant and a slope explain all
    constexpr double kFirstStep = 1.05;
    constexpr int kFiner = 12;
    const double length_s = static_cast<double>(x.size()) / rate_hz;
    double best_hz = 0.0;
    double most = 0.0;
    const auto look_at = [&](double hz) {
        if (!kTracedHz.contains(hz) || hz > 0.45 * rate_hz) return;
        const double explained = explained_by(x, rate_hz, hz);
        if (explained > most) {
            most = explained;
            best_hz = hz;
        }
    };
    for (double hz = std::max(kTracedHz.low, kLeastCycles / length_s); hz <= kTracedHz.high;
         hz *= kFirstStep) {
        look_at(hz);
    }
    if (!(most > 0.0)) return std::nullopt;
    double step = kFirstStep;
    for (int round = 0; round < kFiner; ++round) {
        step = std::sqrt(step);
        const double middle_hz = best_hz;
        look_at(middle_hz * step);
        look_at(middle_hz / step);
    }
    return best_hz;
}

// sqrt(2) rms about each time; near the ends, of a window that begins or ends there.
Track amplitude_track(const Waveform& recording, const FrequencyCurve& frequency) {
    const std::vector<double>& x = recording.samples_g;
    std::vector<double> energy{0.0};
    for (const double sample : x) energy.push_back(energy.back() + sample * sample);
    Track track;
    for (const double t_s : times_through(duration_s(recording), kEnvelopeStepS)) {
        const auto hz = frequency_at(frequency, t_s);
        const double window_s = hz ? whole_half_cycles_s(*hz, duration_s(recording)) : kEnvelopeS;
        const std::size_t window = std::min(sample_count(window_s, recording.rate_hz), x.size());
        if (window == 0) continue;
        const double ahead_s = std::max(t_s - 0.5 * window_s, 0.0);
        const std::size_t begin =
            std::min(sample_count(ahead_s, recording.rate_hz), x.size() - window);
        const double sum = energy[begin + window] - energy[begin];
        track.add(t_s, std::sqrt(2.0 * sum / static_cast<double>(window)));
    }
    return track;
}

double amplitude_about(const Track& amplitude, double t_s) {
    const auto at = std::ranges::lower_bound(amplitude.times_s, t_s);
    const auto k = static_cast<std::size_t>(at - amplitude.times_s.begin());
    return amplitude.heights[std::min(k, amplitude.heights.size() - 1)];
}

// In 40 ms, or four cycles of what is strongest on the whole: of fewer, a sine's image below 0 Hz
// moves the peak.
Track frequency_track(const Waveform& recording, const Track& amplitude) {
    const std::span<const double> x = recording.samples_g;
    Track track;
    const auto whole_hz = strongest_hz(without_mean(x), recording.rate_hz);
    if (!whole_hz) return track;
    const double window_s = std::max(kSpectrumS, 4.0 / *whole_hz);
    const std::size_t window = std::min(sample_count(window_s, recording.rate_hz), x.size());
    const double floor_g = kEnergyFloor * std::ranges::max(amplitude.heights);
    for (const double t_s : times_through(duration_s(recording), kSpectrumStepS)) {
        if (amplitude_about(amplitude, t_s) < floor_g) continue;
        const std::size_t middle = sample_count(t_s, recording.rate_hz);
        // Only whole windows: at the ends the frequency is held.
        if (middle < window / 2 || middle - window / 2 + window > x.size()) continue;
        const auto windowed = hann_windowed(x.subspan(middle - window / 2, window));
        if (const auto hz = strongest_hz(windowed, recording.rate_hz)) track.add(t_s, *hz);
    }
    return track;
}

FrequencyCurve curve_of(const Track& frequency) {
    FrequencyCurve curve;
    for (std::size_t k = 0; k < frequency.heights.size(); ++k) {
        curve.push_back({frequency.times_s[k], frequency.heights[k]});
    }
    return curve;
}

void draw_frequency(TracedPattern& result, const Track& track, const TraceParams& params) {
    if (track.heights.empty()) return;
    const auto [low, high] = std::ranges::minmax(track.heights);
    const double middle_hz = 0.5 * (low + high);
    result.pattern.carriers.front().frequency_hz = middle_hz;
    result.frequency_error_hz = high - middle_hz;
    if (result.frequency_error_hz <= params.frequency_tolerance_hz) return;
    const Thinning line =
        thinned(track.times_s, track.heights, params.most_points, params.frequency_tolerance_hz);
    for (const std::size_t k : line.kept) {
        result.pattern.frequency_curve.push_back({track.times_s[k], track.heights[k]});
    }
    result.frequency_error_hz = line.largest_error;
}

void draw_amplitude(TracedPattern& result, const Track& track, double largest_g,
                    const TraceParams& params) {
    const Thinning line = thinned(track.times_s, track.heights, params.most_points,
                                  params.amplitude_tolerance * largest_g);
    for (const std::size_t k : line.kept) {
        result.pattern.amplitude_curve.push_back(
            {track.times_s[k], std::min(track.heights[k] / largest_g, 1.0)});
    }
    result.amplitude_error_g = line.largest_error;
}

}  // namespace

TracedPattern traced(const Waveform& recording, const TraceParams& params) {
    TracedPattern result;
    result.pattern.duration_s = duration_s(recording);
    result.pattern.amplitude_g = 0.0;
    const Track rough = amplitude_track(recording, {});
    if (rough.heights.empty() || !(std::ranges::max(rough.heights) > 0.0)) return result;
    Track frequency = frequency_track(recording, rough);
    if (frequency.heights.empty() && recording.samples_g.size() >= kFewestSamples) {
        const auto guess = guessed_hz(recording.samples_g, recording.rate_hz);
        if (guess) frequency.add(0.5 * duration_s(recording), *guess);
        result.frequency_is_a_guess = guess.has_value();
    }
    const Track amplitude = amplitude_track(recording, curve_of(frequency));
    const double largest_g = std::ranges::max(amplitude.heights);
    result.pattern.amplitude_g = largest_g;
    draw_amplitude(result, amplitude, largest_g, params);
    draw_frequency(result, frequency, params);
    result.pattern = clamped(std::move(result.pattern));
    return result;
}

}  // namespace tact
