#include "devices/rumble/two_band_tracking.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "devices/rumble/sine_fit.h"
#include "model/common/units.h"

namespace tact {

namespace {

constexpr double kWindowS = 0.05;
constexpr double kSilenceBlockS = 0.005;
constexpr double kSilence = 0.02;       // of the loudest block under the window
constexpr double kShortestFitS = 0.01;  // anything shorter is a click, told by its peak
constexpr double kSteadyEnough = 0.05;  // share that a long window may leave
constexpr double kNoiseFrom = 0.5;      // share lost by two sines
constexpr double kFoldedHz = 160.0;
constexpr double kLowAloneBelowHz = 200.0;  // a single tone below goes to the low band

// Weight zero for what is silent, and for what a silence parts from the frame itself.
void leave_out_silence(Stretch& stretch, double half_hop_s) {
    const auto block = static_cast<std::size_t>(std::lround(kSilenceBlockS * stretch.rate_hz));
    const std::size_t blocks = (stretch.samples.size() + block - 1) / block;
    const std::size_t size = stretch.samples.size();
    std::vector<double> peaks(blocks, 0.0);
    for (std::size_t n = 0; n < size; ++n) {
        peaks[n / block] = std::max(peaks[n / block], std::abs(stretch.samples[n]));
    }
    const double threshold = kSilence * *std::ranges::max_element(peaks);
    const auto is_silent = [&](std::size_t b) { return b >= blocks || peaks[b] <= threshold; };
    for (std::size_t b = 0; b < blocks;) {
        std::size_t end = b;
        while (end < blocks && !is_silent(end)) ++end;
        // The note from block b to block `end`, to the sample.
        std::size_t from = b * block;
        std::size_t to = std::min(end * block, size);
        while (from < to && std::abs(stretch.samples[from]) <= threshold) ++from;
        while (to > from && std::abs(stretch.samples[to - 1]) <= threshold) --to;
        const bool in_frame =
            from < to && stretch.time_s(from) < half_hop_s && stretch.time_s(to - 1) >= -half_hop_s;
        for (std::size_t n = b * block; n < std::min((end + 1) * block, size); ++n) {
            if (!in_frame || n < from || n >= to) stretch.weights[n] = 0.0;
        }
        b = end + 1;
    }
}

Stretch stretch_around(const Drive& drive, double middle_s, double window_s, double hop_s) {
    Stretch stretch;
    stretch.rate_hz = drive.rate_hz;
    const auto count = static_cast<std::ptrdiff_t>(std::lround(window_s * drive.rate_hz));
    const auto first =
        static_cast<std::ptrdiff_t>(std::lround(middle_s * drive.rate_hz)) - count / 2;
    stretch.first_s = static_cast<double>(first) / drive.rate_hz - middle_s;
    for (std::ptrdiff_t n = 0; n < count; ++n) {
        const std::ptrdiff_t at = first + n;
        const bool inside = at >= 0 && at < std::ssize(drive.samples);
        stretch.samples.push_back(inside ? drive.samples[static_cast<std::size_t>(at)] : 0.0);
        const double turn = (static_cast<double>(n) + 0.5) / static_cast<double>(count);
        stretch.weights.push_back(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn));
    }
    leave_out_silence(stretch, hop_s / 2.0);
    return stretch;
}

double largest_in_hop(const Stretch& stretch, double hop_s, const std::optional<Tone>& of) {
    double largest = 0.0;
    for (std::size_t n = 0; n < stretch.samples.size(); ++n) {
        const double t_s = stretch.time_s(n);
        if (std::abs(t_s) > hop_s / 2.0 || stretch.weights[n] <= 0.0) continue;
        largest = std::max(largest, std::abs(of ? of->at(t_s) : stretch.samples[n]));
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

RumbleFrame noise_frame(const Stretch& stretch) {
    const Spectrum spectrum = weighted_spectrum(stretch);
    double squares = 0.0;
    for (const double weight : stretch.weights) squares += weight * weight;
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
TrackedFrame click(const Stretch& stretch, TrackedFrame frame, double hop_s) {
    const std::optional<Tone> tone = strongest_tone(stretch);
    frame.share_lost = 1.0;
    if (!tone) return frame;
    std::vector<Tone> none;
    Tone peak = *tone;
    peak.frequency_hz = std::max(peak.frequency_hz, kLowestLowBandHz);
    peak.cosine = largest_in_hop(stretch, hop_s, std::nullopt);
    frame.rumble = placed({peak}, none);
    frame.noise = true;
    return frame;
}

// The amplitude of a swell of 160 Hz that is the low tone's rectified course.
void fold(const Stretch& stretch, std::vector<Tone>& tones, TrackedFrame& frame, double hop_s) {
    if (tones.empty() || !is_below(tones[0].frequency_hz, kLowestLowBandHz)) return;
    const double swell = largest_in_hop(stretch, hop_s, tones[0]);
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

double share_of_time(const Stretch& stretch, double hop_s) {
    std::size_t inside = 0;
    std::size_t sounding = 0;
    for (std::size_t n = 0; n < stretch.samples.size(); ++n) {
        if (std::abs(stretch.time_s(n)) > hop_s / 2.0) continue;
        ++inside;
        if (stretch.weights[n] > 0.0) ++sounding;
    }
    return inside == 0 ? 0.0 : static_cast<double>(sounding) / static_cast<double>(inside);
}

double sounding_s(const Stretch& stretch) {
    const auto silent = std::ranges::count_if(stretch.weights, [](double w) { return w <= 0.0; });
    return static_cast<double>(std::ssize(stretch.weights) - silent) / stretch.rate_hz;
}

double mean_square(const Stretch& stretch) {
    double weights = 0.0;
    for (const double weight : stretch.weights) weights += weight;
    return weights > 0.0 ? energy_of(stretch) / weights : 0.0;
}

}  // namespace

std::size_t frame_count(const Drive& drive, double hop_s) {
    const auto samples = static_cast<double>(drive.samples.size());
    // A rounding error of the duration makes no frame of its own.
    return static_cast<std::size_t>(std::ceil(samples / (drive.rate_hz * hop_s) - 1e-6));
}

TrackedFrame tracked_frame(const Drive& drive, std::size_t k, double hop_s) {
    const double middle_s = (static_cast<double>(k) + 0.5) * hop_s;
    Stretch stretch = stretch_around(drive, middle_s, kWindowS, hop_s);
    TrackedFrame frame;
    frame.energy = mean_square(stretch) * share_of_time(stretch, hop_s);
    if (!(frame.energy > 0.0)) return frame;
    if (sounding_s(stretch) < kShortestFitS) return click(stretch, frame, hop_s);
    SineFit fit = fitted_sines(stretch, kWindowS);
    if (fit.share_left > kWellFitted) {
        // Twice the time tells closer tones apart, where they are steady enough to show it.
        const Stretch longer = stretch_around(drive, middle_s, kLongWindowS, hop_s);
        const SineFit steady = fitted_sines(longer, kLongWindowS);
        if (steady.share_left < std::min(fit.share_left / 2.0, kSteadyEnough)) {
            fit = steady;
            stretch = longer;
        }
    }
    frame.share_lost = fit.share_left;
    if (fit.share_left > kNoiseFrom) {
        frame.noise = true;
        frame.rumble = noise_frame(stretch);
        return frame;
    }
    std::vector<Tone> carried;
    fold(stretch, fit.tones, frame, hop_s);
    const RumbleFrame beside = frame.rumble;
    frame.rumble = placed(fit.tones, carried);
    if (frame.folded && beside.low > 0.0) {
        frame.rumble.low = beside.low;
        frame.rumble.low_hz = beside.low_hz;
        frame.rumble = within_one_coil(frame.rumble);
    }
    frame.share_lost = share_left_by(stretch, carried);
    return frame;
}

}  // namespace tact
