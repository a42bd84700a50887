#include "devices/device/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "devices/device/drive.h"

namespace tact {

namespace {

static_assert(std::atomic<double>::is_always_lock_free &&
              std::atomic<const Clip*>::is_always_lock_free &&
              std::atomic<std::uint64_t>::is_always_lock_free);

// Numbers too small to be felt are slow to compute with: until the end of a callback they count as
// zero, and then the thread computes again as it did.
struct FlushDenormals {
#if defined(__SSE2__)
    static constexpr unsigned int kFlushToZero = 0x8000;
    static constexpr unsigned int kDenormalsAreZero = 0x0040;
    unsigned int before = _mm_getcsr();

    FlushDenormals() { _mm_setcsr(before | kFlushToZero | kDenormalsAreZero); }
    ~FlushDenormals() { _mm_setcsr(before); }
#else
    FlushDenormals() {}
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
};

// Less held back than this is not felt, and not told.
constexpr float kAllButNothing = 0.98F;

// A first loop ends by its own limit, where both are the same.
constexpr double kWarmSlackS = 0.01;

// From one frame to the next.
struct Steps {
    float fade = 0.0F;
    float cross = 0.0F;
    float pull = 0.0F;  // of what a level is off ...
    float rise = 0.0F;  // ... but no more upwards
};

Steps steps_at(double rate_hz) {
    const auto share = [rate_hz](double seconds) {
        return static_cast<float>(1.0 / (seconds * rate_hz));
    };
    return {share(kRampS), share(kCrossS), 4.6F * share(kSettleS),  // e^-4.6 = 1 %
            share(kRiseS)};
}

// A frame that may leave: never beyond the ceiling, and what is no number is silence.
float kept(float sample, float ceiling) {
    return std::isfinite(sample) ? std::clamp(sample, -ceiling, ceiling) : 0.0F;
}

MotionStretch stretch_of(const Clip* clip, std::size_t at, double levels,
                         const Playback& playback) {
    if (clip == nullptr || clip->travel.motions.empty()) return {};
    const double rate_hz = playback.layout.rate_hz;
    const auto frames = static_cast<double>(playback.own.unsettled);
    const double to_s = static_cast<double>(at) / rate_hz - clip->travel_from_s;
    return {&clip->travel, to_s - frames / rate_hz, to_s, levels / frames};
}

// Before what plays becomes something else, and with each block of the ledger.
void settle_motion(Playback& playback) {
    Playback::Own& own = playback.own;
    if (own.unsettled == 0) return;
    note_motion(playback.ledger, static_cast<double>(own.unsettled) / playback.layout.rate_hz,
                stretch_of(own.has_ended ? nullptr : own.clip, own.at, own.levels, playback),
                stretch_of(own.under, own.under_at, own.under_levels, playback));
    own.unsettled = 0;
    own.levels = 0.0;
    own.under_levels = 0.0;
}

void end_clip(Playback& playback) {
    Playback::Own& own = playback.own;
    settle_motion(playback);
    own.has_ended = true;
    own.under = nullptr;
    own.ended_at = own.frames + 1;
    notes_of(playback, own.clip->serial)
        .end_s.store(own.heard_s + static_cast<double>(own.ended_at) / playback.layout.rate_hz,
                     std::memory_order_relaxed);
    playback.ended.store(own.clip->serial, std::memory_order_release);
    playback.quiet_frames.store(0, std::memory_order_relaxed);
}

// The level that plays before this one leave it, from where it is. After a second only the play
// itself counts.
void ask_ledger(Playback& playback) {
    Playback::Own& own = playback.own;
    const Clip& clip = *own.clip;
    const double rate_hz = playback.layout.rate_hz;
    own.allowed = 1.0F;
    if (static_cast<double>(own.fresh_frames) >= rate_hz) return;
    const double at_s = static_cast<double>(own.at) / rate_hz;
    const double by_rms =
        allowed_level(playback.ledger, clip.load, at_s, clip.loop, clip.rms_limit);
    const double by_travel =
        level_within_travel(playback.ledger.motion, clip.travel, at_s - clip.travel_from_s);
    own.allowed = static_cast<float>(std::min(by_rms, by_travel));
}

void begin_clip(Playback& playback, const Clip* clip) {
    Playback::Own& own = playback.own;
    settle_motion(playback);
    // The end of the one before that this one did not wait for.
    own.under = clip != nullptr && clip->waits && own.leaves_end ? own.clip : nullptr;
    own.under_gain = own.gain;
    own.is_end = own.under != nullptr;
    own.leaves_end = false;
    own.clip = clip;
    own.at = 0;
    own.clip_frames = 0;
    own.fresh_frames = 0;
    own.fade = 1.0F;
    own.has_ended = clip == nullptr || clip->samples.empty();
    if (clip == nullptr) return;
    PlayNotes& notes = notes_of(playback, clip->serial);
    notes.rounds.store(0, std::memory_order_relaxed);
    notes.dropouts.store(0, std::memory_order_relaxed);
    notes.clipped.store(false, std::memory_order_relaxed);
    notes.kept.store(1.0F, std::memory_order_relaxed);
    notes.is_warm.store(false, std::memory_order_relaxed);
    ask_ledger(playback);
    playback.begun.store(clip->serial, std::memory_order_release);
    if (own.has_ended) end_clip(playback);
}

// A limiter that knows the whole clip turns all of it down: bent peaks would be another vibration.
float held_back(Playback& playback, float level) {
    const Clip* clip = playback.own.clip;
    if (clip == nullptr) return level;
    const auto ceiling = static_cast<float>(playback.layout.ceiling);
    auto most = static_cast<float>(
        kept_level(static_cast<double>(level), static_cast<double>(clip->largest_level)));
    if (most * clip->peak > ceiling) most = ceiling / clip->peak;
    PlayNotes& notes = notes_of(playback, clip->serial);
    const float allowed = playback.own.allowed;
    if (allowed < kAllButNothing * most) {
        const float kept = allowed / most;
        if (kept < notes.kept.load(std::memory_order_relaxed)) {
            notes.kept.store(kept, std::memory_order_relaxed);
        }
    }
    if (most < level || allowed < kAllButNothing * most) {
        notes.clipped.store(true, std::memory_order_relaxed);
    }
    return std::min(most, allowed);
}

// The same play, which is to become something else.
bool is_change(const Clip* from, const Clip* to) {
    return from != nullptr && to != nullptr && from != to && from->serial == to->serial;
}

bool may_change(const Playback& playback, const Clip* wanted) {
    const Playback::Own& own = playback.own;
    return is_change(own.clip, wanted) && !own.has_ended && own.under == nullptr &&
           own.clip->loop && wanted->loop && !wanted->samples.empty();
}

// From the same time within it; a shorter loop is as far as it would be had it always played.
void begin_change(Playback& playback, const Clip* wanted) {
    Playback::Own& own = playback.own;
    settle_motion(playback);
    own.under = std::exchange(own.clip, wanted);
    own.is_end = false;
    own.under_at = own.at;
    own.under_gain = own.gain;
    own.crossed = 0.0F;
    own.at %= wanted->samples.size();
    own.fresh_frames = 0;
    ask_ledger(playback);
}

// A sample of the clip, and of what fades under it.
float mixed_sample(Playback::Own& own, float cross_step) {
    const float sample = own.clip->samples[own.at] * own.gain;
    ++own.unsettled;
    if (own.under == nullptr || own.is_end) own.levels += static_cast<double>(own.gain * own.fade);
    if (own.under == nullptr) return sample;
    if (own.is_end) {
        own.under_levels += static_cast<double>(own.under_gain * own.fade);
        const float end = own.under->samples[own.under_at] * own.under_gain;
        if (++own.under_at >= own.under->samples.size()) own.under = nullptr;
        return sample + end;
    }
    const float t = own.crossed;
    const float share = t * t * (3.0F - 2.0F * t);
    own.levels += static_cast<double>(share * own.gain * own.fade);
    own.under_levels += static_cast<double>((1.0F - share) * own.under_gain * own.fade);
    const float before = own.under->samples[own.under_at] * own.under_gain;
    own.under_at = own.under_at + 1 < own.under->samples.size() ? own.under_at + 1 : 0;
    own.crossed += cross_step;
    if (own.crossed >= 1.0F) own.under = nullptr;
    return before + share * (sample - before);
}

// The next frame of the clip, faded while another one is wanted, or none, or it is over its time.
// If the clip ends by itself, its last `spare` frames are left out.
float next_sample(Playback& playback, bool leaving, const Steps& steps, std::size_t spare) {
    Playback::Own& own = playback.own;
    if (own.has_ended) {
        ++own.unsettled;
        return 0.0F;
    }
    const float sample = mixed_sample(own, steps.cross) * own.fade;
    const bool is_over = own.clip_frames >= own.clip->longest_frames;
    const bool is_warm = playback.ledger.driven_s > own.clip->rest_after_s + kWarmSlackS;
    if (is_warm && !is_over) {
        notes_of(playback, own.clip->serial).is_warm.store(true, std::memory_order_relaxed);
    }
    if (leaving || is_over || is_warm || own.fade < 1.0F) own.fade -= steps.fade;
    ++own.clip_frames;
    ++own.fresh_frames;
    const std::size_t last = own.clip->loop ? 0 : spare;
    if (++own.at + last >= own.clip->samples.size()) {
        own.leaves_end = own.at < own.clip->samples.size();
        own.under_at = own.leaves_end ? own.at : own.under_at;
        notes_of(playback, own.clip->serial).rounds.fetch_add(1, std::memory_order_relaxed);
        if (!own.clip->loop) end_clip(playback);
        own.at = 0;
    }
    if (!own.has_ended && own.fade <= 0.0F) end_clip(playback);
    return sample;
}

// Where the clip that is being read began, or its newest round of a loop.
void tell_origin(Playback& playback, double heard_s, std::size_t frame) {
    const double ahead = static_cast<double>(frame) - static_cast<double>(playback.own.at);
    notes_of(playback, playback.own.clip->serial)
        .origin_s.store(heard_s + ahead / playback.layout.rate_hz, std::memory_order_relaxed);
}

// Something of a clip is being rendered, or on its way to be heard.
bool is_under_way(const Playback& playback) {
    const Playback::Own& own = playback.own;
    const auto late =
        static_cast<std::uint64_t>(playback.layout.latency_s * playback.layout.rate_hz);
    return own.clip != nullptr && (!own.has_ended || own.frames < own.ended_at + late);
}

// A waiting one lets the one before it end, and rests after that.
bool may_begin(const Playback& playback, const Clip* wanted) {
    const Playback::Own& own = playback.own;
    // What a play is changed into once it has ended does not bring it back.
    if (own.clip == wanted || !own.has_ended || is_change(own.clip, wanted)) return false;
    if (wanted == nullptr) return true;
    const auto pad = static_cast<std::uint64_t>(kPadS * playback.layout.rate_hz);
    if (own.frames < pad) return false;
    const auto rest = static_cast<std::uint64_t>(std::max<std::int64_t>(0, wanted->rest_frames));
    return !wanted->waits || own.frames >= own.ended_at + rest;
}

// How much of the clip before it a waiting one does not wait for.
std::size_t spare_frames(const Playback& playback, const Clip* wanted) {
    if (wanted == nullptr || wanted == playback.own.clip || !wanted->waits) return 0;
    return static_cast<std::size_t>(std::max<std::int64_t>(0, -wanted->rest_frames));
}

// True: what is on its way has to go now. Where the fade is heard in time it need not.
bool answers_cut(Playback& playback) {
    if (playback.cut.load(std::memory_order_acquire) != Cut::asked) return false;
    const bool cuts = playback.layout.latency_s > kLongestFadedS && is_under_way(playback);
    if (cuts && !playback.own.has_ended) end_clip(playback);
    const bool is_last = cuts && !playback.layout.takes_back;
    playback.cut.store(is_last ? Cut::done : Cut::none, std::memory_order_release);
    return cuts;
}

}  // namespace

bool render(Playback& playback, float* interleaved, std::size_t frames, double heard_s,
            bool broke_off) {
    const FlushDenormals flush;
    const StreamLayout& layout = playback.layout;
    Playback::Own& own = playback.own;
    std::fill_n(interleaved, frames * layout.channels, 0.0F);
    if (broke_off && is_under_way(playback)) {
        notes_of(playback, own.clip->serial).dropouts.fetch_add(1, std::memory_order_relaxed);
    }
    const Clip* wanted = playback.wanted.load(std::memory_order_seq_cst);
    if (answers_cut(playback)) return false;
    const auto level = static_cast<float>(kept_level(static_cast<double>(playback.level.load())));
    const Steps steps = steps_at(layout.rate_hz);
    const auto ceiling = static_cast<float>(layout.ceiling);
    own.heard_s = heard_s - static_cast<double>(own.frames) / layout.rate_hz;
    const double frame_s = 1.0 / layout.rate_hz;
    if (!own.has_ended) tell_origin(playback, heard_s, 0);
    float target = held_back(playback, level);
    float peak = 0.0F;
    for (std::size_t n = 0; n < frames; ++n, ++own.frames) {
        if (may_begin(playback, wanted)) {
            begin_clip(playback, wanted);
            target = held_back(playback, level);
            own.gain = target;  // nothing sounds yet that could jump
            if (!own.has_ended) tell_origin(playback, heard_s, n);
        }
        if (may_change(playback, wanted)) {
            begin_change(playback, wanted);
            target = held_back(playback, level);
            own.gain = std::min(own.gain, target);  // its own limits hold at once
            tell_origin(playback, heard_s, n);
        }
        const float off = target - own.gain;
        own.gain =
            std::abs(off) < 1e-5F ? target : own.gain + std::min(off * steps.pull, steps.rise);
        const bool leaving = own.clip != wanted && !is_change(own.clip, wanted) &&
                             (wanted == nullptr || !wanted->waits);
        const std::size_t spare = spare_frames(playback, wanted);
        const float held = kept(next_sample(playback, leaving, steps, spare), ceiling);
        float* const frame = interleaved + n * layout.channels;
        if (layout.everywhere) std::fill_n(frame, layout.channels, held);
        frame[layout.channel] = held;
        peak = std::max(peak, std::abs(held));
        const bool is_driven = !own.has_ended;
        if (!note(playback.ledger, static_cast<double>(held), frame_s, is_driven)) continue;
        settle_motion(playback);
        if (is_driven && own.allowed < 1.0F) {
            ask_ledger(playback);
            target = held_back(playback, level);
        }
    }
    if (own.has_ended) playback.quiet_frames.fetch_add(frames, std::memory_order_relaxed);
    if (peak > playback.peak.load(std::memory_order_relaxed)) {
        playback.peak.store(peak, std::memory_order_relaxed);
    }
    playback.held_under.store(own.under, std::memory_order_seq_cst);
    playback.held.store(own.clip, std::memory_order_seq_cst);
    playback.calls.fetch_add(1, std::memory_order_seq_cst);
    return true;
}

}  // namespace tact
