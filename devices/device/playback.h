// What an audio callback does, without the audio library: one clip into one channel of a stream.
//
// Everything was prepared before; the callback indexes it, scales it and tells by atomics how far
// it is. It allocates nothing, waits for nothing and calls nobody (tests/devices/audio lets it run
// where the system forbids all that).
//
// Source    rules for callbacks: R. Bencina, "Real-time audio programming 101", 2011.
// Output    interleaved frames: silence on all channels but one, or the same on all; never NaN.
//           No sound in the first kPadS of a stream, as servers lose some of it. A clip that is
//           stopped fades out in kRampS where the output is short enough for that to be heard in
//           time, or takes back what is on its way; otherwise the stream is cut. A lower level
//           takes about as long as a fade, a higher one up to kRiseS, changes or not. What plays
//           before have left of an actuator's limits (devices/device/ledger.h) holds all of a clip
//           back until they are a second back. A loop that is changed continues from where it is:
//           with w rising smoothly from 0 to 1 within kCrossS, (1 - w) before + w after, which is
//           never above the larger one, nor steps by more than the two do and their difference /
//           600.
// Left out  gaps that nobody tells (devices/device/supply.h); starting in the middle of a clip;
//           ramps of a pattern's own start and end (devices/device/protection.h).
// Exact     at a settled level each frame is sample * level, rounded once; where nothing was played
//           within the last second the ledger holds nothing back.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "devices/device/clip.h"
#include "devices/device/ledger.h"

namespace tact {

inline constexpr double kPadS = 0.1;      // of silence before the first clip and after the last
inline constexpr double kRampS = 0.005;   // of a stop: with 10 ms of latency it is silent in 20
inline constexpr double kCeiling = 0.8;   // of full scale: no sample leaves that is larger
inline constexpr double kCrossS = 0.02;   // from a loop to what it is changed into
inline constexpr double kSettleS = 0.01;  // until a lower level is reached to 1 %
inline constexpr double kRiseS = 0.2;     // of a level from nothing to all: one click is no blow
// Between a frame's rendering and its being heard: with more of it a stop has to cut the stream.
inline constexpr double kLongestFadedS = 0.0125;

// Properties of a stream, fixed while it runs.
struct StreamLayout {
    double rate_hz = 48'000.0;
    std::size_t channels = 1;
    std::size_t channel = 0;
    double ceiling = kCeiling;
    bool everywhere = false;  // on all channels instead
    double latency_s = 0.0;   // between a frame's rendering and its being heard
    // Whoever renders can still change what is on its way. A stop then writes a fade over it, and
    // the stream continues in silence.
    bool takes_back = false;
};

// How one play went.
struct PlayNotes {
    std::atomic<double> origin_s = 0.0;     // stream time at which its start is heard
    std::atomic<std::uint64_t> rounds = 0;  // of a loop that are through
    std::atomic<std::uint64_t> dropouts = 0;
    std::atomic<bool> clipped = false;  // its level had to be held back
    std::atomic<float> kept = 1.0F;     // least share of that which what came before it has left
    std::atomic<bool> is_warm = false;  // it ended as the actuator had been driven for too long
    std::atomic<double> end_s = 0.0;    // stream time at which its end is heard
};

// A stop that cannot wait for a fade: asked for by anyone, done by the callback.
enum class Cut { none, asked, done };

// Between the callback and one control thread; level, peak and cut between any threads.
struct Playback {
    StreamLayout layout;

    // To the callback.
    // Null: none; one that has ended stays silent. Another one of the same serial is what this play
    // is changed into; a further one waits until it has come to that.
    std::atomic<const Clip*> wanted = nullptr;
    std::atomic<float> level = 0.0F;

    // From the callback.
    std::atomic<const Clip*> held_under = nullptr;  // being read: what fades under it ...
    std::atomic<const Clip*> held = nullptr;        // ... and the clip; written in this order
    std::atomic<std::uint64_t> begun = 0;           // serial of the clip that began last
    std::atomic<std::uint64_t> ended = 0;           // ... and that ended, or was stopped
    std::array<PlayNotes, 2> notes{};               // of the serials, in turn
    std::atomic<std::uint64_t> calls = 0;
    std::atomic<std::uint64_t> quiet_frames = 0;  // since the last clip, or since the stream began
    std::atomic<float> peak = 0.0F;               // of full scale; whoever reads it sets it to 0
    std::atomic<Cut> cut = Cut::none;

    // The callback's while a stream is open: all that the actuator was given, of any play.
    Ledger ledger;

    // The callback's own.
    struct Own {
        const Clip* clip = nullptr;
        bool has_ended = true;
        std::size_t at = 0;           // next frame of the clip
        const Clip* under = nullptr;  // what was before, while it still sounds: a loop ...
        bool is_end = false;          // ... or the end of a clip that was not waited for
        bool leaves_end = false;      // the clip has ended, and its last frames are still to come
        std::size_t under_at = 0;
        float under_gain = 0.0F;
        float crossed = 1.0F;  // 0..1: how far it has come from that to the clip
        std::uint64_t frames = 0;
        std::uint64_t clip_frames = 0;   // since the clip began
        std::uint64_t fresh_frames = 0;  // ... or became what it is
        std::size_t unsettled = 0;       // frames whose motion is still to be noted ...
        double levels = 0.0;             // ... the clip's levels in them, summed up ...
        double under_levels = 0.0;       // ... and those of what fades under it
        float allowed = 1.0F;            // the largest level that the ledger leaves it
        double heard_s = 0.0;            // of the stream's frame 0, as this call knows it
        std::uint64_t ended_at = 0;      // frame of the stream
        float gain = 0.0F;
        float fade = 1.0F;
    } own;
};

inline PlayNotes& notes_of(Playback& playback, std::uint64_t serial) {
    return playback.notes[serial % 2];
}

// The whole callback: writes `frames` frames, of which the first will be heard at `heard_s` of the
// steady clock, the stream's time. `broke_off`: there was a gap before them. False: these frames,
// and all that are on their way, shall not be heard: they are to be faded and taken back, or the
// stream cut.
bool render(Playback& playback, float* interleaved, std::size_t frames, double heard_s,
            bool broke_off = false);

}  // namespace tact
