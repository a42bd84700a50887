#include "devices/rumble/rumble_plan.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "devices/rumble/motor_envelope.h"
#include "model/signal/resample.h"

namespace tact {

namespace {

Drive usable(Drive drive) {
    for (double& sample : drive.samples) {
        if (!std::isfinite(sample)) sample = 0.0;
    }
    if (drive.rate_hz == kModelRateHz) return drive;
    Waveform waveform = resampled({drive.rate_hz, std::move(drive.samples)}, kModelRateHz);
    return {waveform.rate_hz, std::move(waveform.samples_g)};
}

}  // namespace

RumblePlan::RumblePlan(Drive drive, Language language, double period_s)
    : drive_(usable(std::move(drive))),
      period_s_(period_s),
      size_(frame_count(drive_, period_s)),
      frames_(size_) {
    assert(language != Language::waveform && "a waveform is no frames");
    if (language == Language::two_bands) return;
    const std::vector<RumbleFrame> frames = language == Language::motor_pair
                                                ? motor_pair_frames(drive_, period_s)
                                                : intensity_frames(drive_, period_s);
    for (std::size_t k = 0; k < size_; ++k) frames_[k] = TrackedFrame{.rumble = frames[k]};
}

const TrackedFrame& RumblePlan::frame(std::size_t k) {
    assert(k < size_ && "a frame beyond the end");
    if (!frames_[k]) frames_[k] = tracked_frame(drive_, k, period_s_);
    return *frames_[k];
}

}  // namespace tact
