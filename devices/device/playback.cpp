#include "devices/device/playback.h"

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tact {

namespace {

static_assert(std::atomic<double>::is_always_lock_free &&
              std::atomic<const Clip*>::is_always_lock_free &&
              std::atomic<std::uint64_t>::is_always_lock_free);

// Numbers too small to be felt are slow to compute with; here they count as zero.
void flush_denormals() {
#if defined(__SSE2__)
    constexpr unsigned int kFlushToZero = 0x8000;
    constexpr unsigned int kDenormalsAreZero = 0x0040;
    _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
#endif
}

void end_clip(Playback& playback) {
    Playback::Own& own = playback.own;
    own.has_ended = true;
    playback.ended.store(own.clip->serial, std::memory_order_release);
    playback.quiet_frames.store(0, std::memory_order_relaxed);
}

void begin_clip(Playback& playback, const Clip* clip, float gain) {
    Playback::Own& own = playback.own;
    own.clip = clip;
    own.at = 0;
    own.fade = 1.0F;
    own.gain = gain;  // nothing sounds yet that could jump
    own.has_ended = clip == nullptr || clip->samples.empty();
    if (clip == nullptr) return;
    playback.rounds.store(0, std::memory_order_relaxed);
    playback.begun.store(clip->serial, std::memory_order_release);
    if (own.has_ended) end_clip(playback);
}

// A limiter that knows the whole clip turns all of it down: bent peaks would be another vibration.
float held_back(Playback& playback, float level) {
    const Clip* clip = playback.own.clip;
    const auto ceiling = static_cast<float>(playback.layout.ceiling);
    if (clip == nullptr || level * clip->peak <= ceiling) return level;
    playback.clipped.store(true, std::memory_order_relaxed);
    return ceiling / clip->peak;
}

// The next frame of the clip, faded while another one is wanted, or none.
float next_sample(Playback& playback, bool leaving, float fade_step) {
    Playback::Own& own = playback.own;
    if (own.has_ended) return 0.0F;
    const float sample = own.clip->samples[own.at] * own.gain * own.fade;
    if (leaving) own.fade -= fade_step;
    if (++own.at == own.clip->samples.size()) {
        own.at = 0;
        playback.rounds.fetch_add(1, std::memory_order_relaxed);
        if (!own.clip->loop) end_clip(playback);
    }
    if (!own.has_ended && own.fade <= 0.0F) end_clip(playback);
    return sample;
}

// Where the clip that is being read began, or its newest round of a loop.
void tell_origin(Playback& playback, double heard_s, std::size_t frame) {
    const double ahead = static_cast<double>(frame) - static_cast<double>(playback.own.at);
    playback.origin_s.store(heard_s + ahead / playback.layout.rate_hz, std::memory_order_relaxed);
}

}  // namespace

void render(Playback& playback, float* interleaved, std::size_t frames, double heard_s,
            bool broke_off) {
    flush_denormals();
    if (broke_off && !playback.own.has_ended) {
        playback.dropouts.fetch_add(1, std::memory_order_relaxed);
    }
    const StreamLayout& layout = playback.layout;
    Playback::Own& own = playback.own;
    std::fill_n(interleaved, frames * layout.channels, 0.0F);
    const Clip* wanted = playback.wanted.load(std::memory_order_seq_cst);
    const float level = std::clamp(playback.level.load(std::memory_order_relaxed), 0.0F, 1.0F);
    const auto fade_step = static_cast<float>(1.0 / (kRampS * layout.rate_hz));
    const auto pull = static_cast<float>(4.6 / (kSettleS * layout.rate_hz));  // e^-4.6 = 1 %
    const auto ceiling = static_cast<float>(layout.ceiling);
    const auto pad = static_cast<std::uint64_t>(kPadS * layout.rate_hz);
    if (!own.has_ended) tell_origin(playback, heard_s, 0);
    float target = held_back(playback, level);
    float peak = 0.0F;
    for (std::size_t n = 0; n < frames; ++n, ++own.frames) {
        if (own.clip != wanted && own.has_ended && (own.frames >= pad || wanted == nullptr)) {
            begin_clip(playback, wanted, level);
            target = held_back(playback, level);
            own.gain = target;
            if (!own.has_ended) tell_origin(playback, heard_s, n);
        }
        const float off = target - own.gain;
        own.gain = std::abs(off) < 1e-5F ? target : own.gain + off * pull;
        const float sample = next_sample(playback, own.clip != wanted, fade_step);
        float* const frame = interleaved + n * layout.channels;
        const float held = std::clamp(sample, -ceiling, ceiling);
        if (layout.everywhere) std::fill_n(frame, layout.channels, held);
        frame[layout.channel] = held;
        peak = std::max(peak, std::abs(sample));
    }
    if (own.has_ended) playback.quiet_frames.fetch_add(frames, std::memory_order_relaxed);
    if (peak > playback.peak.load(std::memory_order_relaxed)) {
        playback.peak.store(std::min(peak, ceiling), std::memory_order_relaxed);
    }
    playback.held.store(own.clip, std::memory_order_seq_cst);
    playback.calls.fetch_add(1, std::memory_order_seq_cst);
}

}  // namespace tact
