#include "devices/device/clip.h"

#include <algorithm>
#include <cmath>

#include "model/signal/resample.h"

namespace tact {

namespace {

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
        wide.samples_g.push_back(std::isfinite(value) ? value : 0.0);
    }
    return wide;
}

}  // namespace

Clip clip_of(const Drive& drive, double rate_hz, bool loop) {
    Clip clip;
    clip.loop = loop;
    if (drive.samples.empty()) return clip;
    // A loop is cut back to its own length; the margin lets the filter see the seam from both
    // sides.
    const double margin_s = loop ? 0.1 : kClipMarginS;
    const Waveform wide = widened(drive, sample_count(margin_s, drive.rate_hz), loop);
    const std::vector<double> played = resampled(wide, rate_hz).samples_g;
    std::size_t from = 0;
    std::size_t count = played.size();
    if (loop) {
        const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
        from = std::min(sample_count(margin_s, rate_hz), played.size());
        count = std::clamp<std::size_t>(sample_count(length_s, rate_hz), 1, played.size() - from);
    }
    clip.samples.reserve(count);
    for (std::size_t n = from; n < from + count; ++n) {
        clip.samples.push_back(static_cast<float>(played[n]));
        clip.peak = std::max(clip.peak, std::abs(clip.samples.back()));
    }
    return clip;
}

}  // namespace tact
