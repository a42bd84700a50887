#include "model/pattern/traced.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/common/portable.h"
#include "model/signal/short_bursts.h"
#include "model/signal/spectrum.h"
#include "model/signal/thinning.h"

namespace tact {

namespace {

constexpr double kEnvelopeS = 0.010;
constexpr double kEnvelopeStepS = 0.002;
constexpr double kSpectrumS = 0.040;
constexpr double kSpectrumStepS = 0.010;
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

struct Peak {
    double hz = 0.0;
    double energy = 0.0;  // of it and two bins to either side ...
    double all = 0.0;     // ... and of the whole spectrum
};

// The peak in the band; none in silence.
std::optional<Peak> peak_of(std::span<const double> samples, double rate_hz, Range band_hz) {
    const Spectrum spectrum = amplitude_spectrum(samples, rate_hz);
    const std::vector<double>& level = spectrum.amplitude_g;
    std::size_t peak = 0;
    for (std::size_t k = 1; k + 1 < level.size(); ++k) {
        if (!band_hz.contains(frequency_hz(spectrum, k))) continue;
        if (level[k] > 0.0 && (peak == 0 || level[k] > level[peak])) peak = k;
    }
    if (peak == 0) return std::nullopt;
    Peak result{frequency_hz(spectrum, peak)};
    for (std::size_t k = 0; k < level.size(); ++k) {
        const double energy = level[k] * level[k];
        result.all += energy;
        if (k + 2 >= peak && k <= peak + 2) result.energy += energy;
    }
    const double below = level[peak - 1];
    const double above = level[peak + 1];
    if (!(below > 0.0 && above > 0.0)) return result;
    // The top of the parabola through (-1, a), (0, b), (1, c): (a - c) / (2 (a - 2 b + c)).
    const double a = portable::log(below);
    const double b = portable::log(level[peak]);
    const double c = portable::log(above);
    const double bend = a - 2.0 * b + c;
    if (!(bend < 0.0)) return result;
    const double bins = std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
    result.hz += bins * rate_hz / static_cast<double>(spectrum.samples);
    return result;
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
std::optional<double> guessed_hz(std::span<const double> x, double rate_hz, Range band_hz) {
    constexpr double kLeastCycles = 0.75;  // of fewer, a constant and a slope explain all
    constexpr double kFirstStep = 1.05;
    constexpr int kFiner = 12;
    const double length_s = static_cast<double>(x.size()) / rate_hz;
    double best_hz = 0.0;
    double most = 0.0;
    const auto look_at = [&](double hz) {
        if (!band_hz.contains(hz) || hz > 0.45 * rate_hz) return;
        const double explained = explained_by(x, rate_hz, hz);
        if (explained > most) {
            most = explained;
            best_hz = hz;
        }
    };
    for (double hz = std::max(band_hz.low, kLeastCycles / length_s); hz <= band_hz.high;
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

// The strongest frequencies over time, and how much of the energy they stand for.
struct FrequencyTrack {
    Track track;
    double energy = 0.0;
    double all = 0.0;
};

bool is_within(std::span<const ShortBurst> bursts, double t_s) {
    return std::ranges::any_of(bursts, [t_s](const ShortBurst& burst) {
        const double middle_s = burst.begin_s + 0.5 * burst.duration_s;
        return std::abs(t_s - middle_s) < 0.5 * (burst.duration_s + kEnvelopeS);
    });
}

// In 40 ms, or four cycles of what is strongest on the whole: of fewer, a sine's image below 0 Hz
// moves the peak. Beside the bursts.
FrequencyTrack frequency_track(const Waveform& recording, const Track& amplitude, Range band_hz,
                               std::span<const ShortBurst> bursts = {}) {
    const std::span<const double> x = recording.samples_g;
    FrequencyTrack result;
    const auto whole = peak_of(without_mean(x), recording.rate_hz, band_hz);
    if (!whole) return result;
    const double window_s = std::max(kSpectrumS, 4.0 / whole->hz);
    const std::size_t window = std::min(sample_count(window_s, recording.rate_hz), x.size());
    const double floor_g = kEnergyFloor * std::ranges::max(amplitude.heights);
    for (const double t_s : times_through(duration_s(recording), kSpectrumStepS)) {
        if (amplitude_about(amplitude, t_s) < floor_g || is_within(bursts, t_s)) continue;
        const std::size_t middle = sample_count(t_s, recording.rate_hz);
        // Only whole windows: at the ends the frequency is held.
        if (middle < window / 2 || middle - window / 2 + window > x.size()) continue;
        const auto windowed = hann_windowed(x.subspan(middle - window / 2, window));
        const auto peak = peak_of(windowed, recording.rate_hz, band_hz);
        if (!peak) continue;
        result.track.add(t_s, peak->hz);
        result.energy += peak->energy;
        result.all += peak->all;
    }
    return result;
}

// A burst as a transient of the frequency that is strongest in twice its duration, zeros about it.
Transient transient_of(const Waveform& recording, const ShortBurst& burst, Range band_hz) {
    constexpr std::size_t kFiner = 8;
    const std::vector<double>& x = recording.samples_g;
    const double from_s = std::max(0.0, burst.begin_s - 0.5 * burst.duration_s);
    const std::size_t first = std::min(sample_count(from_s, recording.rate_hz), x.size() - 1);
    const std::size_t count =
        std::min(sample_count(2.0 * burst.duration_s, recording.rate_hz), x.size() - first);
    Transient transient{burst.begin_s, burst.amplitude_g};
    transient.duration_s = burst.duration_s;
    auto windowed = hann_windowed(std::span(x).subspan(first, std::max<std::size_t>(count, 1)));
    windowed.resize(kFiner * windowed.size(), 0.0);
    if (const auto peak = peak_of(windowed, recording.rate_hz, band_hz)) {
        transient.frequency_hz = peak->hz;
    }
    return transient;
}

FrequencyCurve curve_of(const Track& frequency) {
    FrequencyCurve curve;
    for (std::size_t k = 0; k < frequency.heights.size(); ++k) {
        curve.push_back({frequency.times_s[k], frequency.heights[k]});
    }
    return curve;
}

// At most `most_points` of every section, its first and last among them.
Thinning thinned_by_sections(const Track& track, double tolerance, const TraceParams& params) {
    if (!(params.section_s > 0.0)) {
        return thinned(track.times_s, track.heights, params.most_points, tolerance);
    }
    Thinning whole;
    for (std::size_t first = 0; first + 1 < track.times_s.size() || first == 0;) {
        const auto beyond = std::ranges::upper_bound(
            track.times_s, track.times_s[first] + params.section_s + 0.5 * kEnvelopeStepS);
        const auto past = static_cast<std::size_t>(beyond - track.times_s.begin());
        const std::size_t last = std::min(std::max(past - 1, first + 1), track.times_s.size() - 1);
        const std::size_t count = last - first + 1;
        const Thinning part =
            thinned(std::span(track.times_s).subspan(first, count),
                    std::span(track.heights).subspan(first, count), params.most_points, tolerance);
        for (const std::size_t k : part.kept) {
            if (k > 0 || first == 0) whole.kept.push_back(first + k);
        }
        whole.largest_error = std::max(whole.largest_error, part.largest_error);
        if (last == first) break;
        first = last;
    }
    return whole;
}

void draw_frequency(TracedPattern& result, const Track& track, const TraceParams& params) {
    if (track.heights.empty()) return;
    const auto [low, high] = std::ranges::minmax(track.heights);
    const double middle_hz = 0.5 * (low + high);
    result.pattern.carriers.front().frequency_hz = middle_hz;
    result.frequency_error_hz = high - middle_hz;
    if (result.frequency_error_hz <= params.frequency_tolerance_hz) return;
    const Thinning line = thinned_by_sections(track, params.frequency_tolerance_hz, params);
    for (const std::size_t k : line.kept) {
        result.pattern.frequency_curve.push_back({track.times_s[k], track.heights[k]});
    }
    result.frequency_error_hz = line.largest_error;
}

void draw_amplitude(TracedPattern& result, const Track& track, double largest_g,
                    const TraceParams& params) {
    const Thinning line =
        thinned_by_sections(track, params.amplitude_tolerance * largest_g, params);
    for (const std::size_t k : line.kept) {
        result.pattern.amplitude_curve.push_back(
            {track.times_s[k], std::min(track.heights[k] / largest_g, 1.0)});
    }
    result.amplitude_error_g = line.largest_error;
}

}  // namespace

TracedPattern traced(const Waveform& recording, const TraceParams& params) {
    constexpr double kNothing = 0.03;  // of the largest amplitude: left beside transients
    TracedPattern result;
    result.pattern.duration_s = duration_s(recording);
    result.pattern.amplitude_g = 0.0;
    const Track rough = amplitude_track(recording, {});
    if (rough.heights.empty() || !(std::ranges::max(rough.heights) > 0.0)) return result;
    FrequencyTrack frequency = frequency_track(recording, rough, params.band_hz);
    if (frequency.track.heights.empty() && recording.samples_g.size() >= kFewestSamples) {
        const auto guess = guessed_hz(recording.samples_g, recording.rate_hz, params.band_hz);
        if (guess) frequency.track.add(0.5 * duration_s(recording), *guess);
        result.frequency_is_a_guess = guess.has_value();
    }
    Track amplitude = amplitude_track(recording, curve_of(frequency.track));
    const double loudest_g = std::ranges::max(amplitude.heights);
    if (params.transients) {
        BurstsFound found = short_bursts(recording, amplitude.heights, kEnvelopeStepS);
        for (const ShortBurst& burst : found.bursts) {
            result.pattern.transients.push_back(transient_of(recording, burst, params.band_hz));
        }
        amplitude.heights = std::move(found.rest_g);
        const bool is_any_left = std::ranges::max(amplitude.heights) > kNothing * loudest_g;
        if (is_any_left && !found.bursts.empty() && !result.frequency_is_a_guess) {
            auto beside = frequency_track(recording, amplitude, params.band_hz, found.bursts);
            if (!beside.track.heights.empty()) frequency = std::move(beside);
        }
    }
    if (frequency.all > 0.0) result.other_share = 1.0 - frequency.energy / frequency.all;
    const double largest_g = std::ranges::max(amplitude.heights);
    if (largest_g > kNothing * loudest_g || !params.transients) {
        result.pattern.amplitude_g = largest_g;
        draw_amplitude(result, amplitude, largest_g, params);
    }
    draw_frequency(result, frequency.track, params);
    result.pattern = clamped(std::move(result.pattern));
    return result;
}

}  // namespace tact
