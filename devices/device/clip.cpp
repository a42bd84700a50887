#include "devices/device/clip.h"

#include <algorithm>
#include <cmath>

#include "model/signal/resample.h"

namespace tact {

namespace {

constexpr double kOversampling = 4.0;
// Half of what is held back at: between the frames of a quieter clip nothing reaches that. What a
// drive of the model's rate can hold is at most 6 % higher there.
constexpr float kQuietPeak = 0.4F;

// No sample of a drive means so much; sums of such numbers are still numbers.
constexpr double kLargestMeant = 1e6;

double meant(double value) {
    return std::isfinite(value) ? std::clamp(value, -kLargestMeant, kLargestMeant) : 0.0;
}

// What lies `n` samples after the start of an endless repetition, n also negative.
double repeated(const std::vector<double>& samples, std::ptrdiff_t n) {
    const auto length = static_cast<std::ptrdiff_t>(samples.size());
    return samples[static_cast<std::size_t>(((n % length) + length) % length)];
}

// The signal with `margin` samples more at either end: of its repetition, or of silence.
Waveform widened(const Drive& drive, std::size_t margin, bool loop) {
    Waveform wide{drive.rate_hz, {}};
    const auto length = static_cast<std::ptrdiff_t>(drive.samples.size());
    const auto reach = static_cast<std::ptrdiff_t>(margin);
    wide.samples_g.reserve(drive.samples.size() + 2 * margin);
    for (std::ptrdiff_t n = -reach; n < length + reach; ++n) {
        double value = 0.0;
        if (loop) {
            value = repeated(drive.samples, n);
        } else if (n >= 0 && n < length) {
            value = drive.samples[static_cast<std::size_t>(n)];
        }
        wide.samples_g.push_back(meant(value));
    }
    return wide;
}

double largest_of(const std::vector<double>& samples, std::size_t from, std::size_t count) {
    double largest = 0.0;
    const std::size_t end = std::min(from + count, samples.size());
    for (std::size_t n = from; n < end; ++n) largest = std::max(largest, std::abs(samples[n]));
    return largest;
}

// The peak of `count` samples from `from` on, and between them.
double true_peak(const Waveform& played, std::size_t from, std::size_t count) {
    const double sampled = largest_of(played.samples_g, from, count);
    const double fine_hz = kOversampling * played.rate_hz;
    if (sampled < static_cast<double>(kQuietPeak) || fine_hz > kHighestRateHz) return sampled;
    const auto times = static_cast<std::size_t>(kOversampling);
    return std::max(sampled, largest_of(resampled(played, fine_hz).samples_g, times * from,
                                        times * (count - 1) + 1));
}

std::uint64_t frames_in(double seconds, double rate_hz) {
    const double frames = seconds * rate_hz;
    // A limit that is NaN is ignored.
    if (!(frames < 1e18)) return std::numeric_limits<std::uint64_t>::max();
    return static_cast<std::uint64_t>(std::max(0.0, frames));
}

}  // namespace

Clip clip_of(const Drive& drive, double rate_hz, bool loop) {
    Clip clip;
    clip.loop = loop;
    clip.largest_level = static_cast<float>(drive.largest_level);
    clip.longest_frames = frames_in(drive.longest_s, rate_hz);
    clip.rms_limit = drive.rms_limit;
    clip.rest_after_s = drive.rest_after_s;
    clip.travel = drive.travel;
    clip.travel_from_s = loop ? 0.0 : kClipMarginS;
    if (drive.samples.empty()) return clip;
    // A loop is cut back to its own length; the margin lets the filter see the seam from both
    // sides.
    const double margin_s = loop ? 0.1 : kClipMarginS;
    const Waveform wide = widened(drive, sample_count(margin_s, drive.rate_hz), loop);
    const Waveform played = resampled(wide, rate_hz);
    std::size_t from = 0;
    std::size_t count = played.samples_g.size();
    if (loop) {
        const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
        from = std::min(sample_count(margin_s, rate_hz), count);
        count = std::clamp<std::size_t>(sample_count(length_s, rate_hz), 1, count - from);
    }
    clip.samples.reserve(count);
    for (std::size_t n = from; n < from + count; ++n) {
        clip.samples.push_back(static_cast<float>(played.samples_g[n]));
    }
    clip.peak = static_cast<float>(true_peak(played, from, count));
    clip.lead_s = loop ? 0.0 : kClipMarginS + drive.lead_s;
    clip.tail_s = loop ? 0.0 : kClipMarginS + drive.tail_s;
    clip.load = load_of(clip.samples, rate_hz);
    return clip;
}

Clip clip_after(const Drive& drive, double rate_hz, double rest_s, const Clip& before) {
    Clip clip = clip_of(drive, rate_hz, false);
    clip.waits = true;
    const double between_s = std::max(0.0, rest_s) - before.tail_s - clip.lead_s;
    clip.rest_frames = std::llround(between_s * rate_hz);
    if (clip.rest_frames >= 0) return clip;
    const auto both = std::min(static_cast<std::size_t>(-clip.rest_frames), before.samples.size());
    clip.rest_frames = -static_cast<std::int64_t>(both);
    clip.samples.resize(std::max(clip.samples.size(), both), 0.0F);
    std::vector<float> sum = clip.samples;
    for (std::size_t n = 0; n < both; ++n) {
        sum[n] += before.samples[before.samples.size() - both + n];
        clip.peak = std::max(clip.peak, std::abs(sum[n]));
    }
    clip.load = load_of(sum, rate_hz);
    return clip;
}

}  // namespace tact
