#include "devices/rumble/rumble_plan.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "model/signal/resample.h"

namespace tact {

namespace {

Drive usable(Drive drive) {
    for (double& sample : drive.samples) {
        if (!std::isfinite(sample)) sample = 0.0;
    }
    if (drive.rate_hz == kModelRateHz) return drive;
    Waveform waveform = resampled({drive.rate_hz, std::move(drive.samples)}, kModelRateHz);
    drive.rate_hz = waveform.rate_hz;
    drive.samples = std::move(waveform.samples_g);
    return drive;
}

}  // namespace

RumblePlan::RumblePlan(Drive drive, Language language, double period_s, double level)
    : drive_(usable(std::move(drive))),
      language_(language),
      period_s_(period_s),
      level_(level),
      size_(frame_count(drive_, period_s)) {
    assert(language != Language::waveform && "a waveform is no frames");
    assert(language != Language::on_off && "on-off times are no frames");
    if (language == Language::two_bands) {
        tracked_.resize(size_);
        return;
    }
    strengths_ = language == Language::motor_pair ? motor_pair_strengths(drive_, period_s)
                                                  : intensity_strengths(drive_, period_s);
    frames_ = frames_at_level();
}

std::vector<RumbleFrame> RumblePlan::frames_at_level() const {
    return language_ == Language::motor_pair ? motor_pair_frames(strengths_, period_s_, level_)
                                             : intensity_frames(strengths_, level_);
}

void RumblePlan::set_level(double level) {
    if (level == level_) return;
    level_ = level;
    if (language_ != Language::two_bands) frames_ = frames_at_level();
}

RumbleFrame RumblePlan::rumble(std::size_t k) {
    assert(k < size_ && "a frame beyond the end");
    if (language_ != Language::two_bands) return frames_[k];
    RumbleFrame frame = tracked(k).rumble;
    frame.low *= level_;
    frame.high *= level_;
    return frame;
}

const TrackedFrame& RumblePlan::tracked(std::size_t k) {
    assert(k < tracked_.size() && "only two bands are tracked");
    if (!tracked_[k]) tracked_[k] = tracked_frame(drive_, k, period_s_);
    return *tracked_[k];
}

}  // namespace tact
