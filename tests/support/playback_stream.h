// What a stream of sound gets from a playback: clips of 150 Hz, four channels, no card.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "devices/device/playback.h"

namespace tact {

namespace playback_stream {

inline constexpr double kRateHz = 48'000.0;
inline constexpr std::size_t kPad = 4800;

// A sine of 150 Hz that starts at its zero.
inline Clip sine(double amplitude, std::size_t frames, bool loop, std::uint64_t serial) {
    Clip clip;
    for (std::size_t n = 0; n < frames; ++n) {
        const double phase = 2.0 * std::numbers::pi * 150.0 * static_cast<double>(n) / kRateHz;
        clip.samples.push_back(static_cast<float>(amplitude * std::sin(phase)));
    }
    clip.peak = static_cast<float>(amplitude);
    clip.loop = loop;
    clip.serial = serial;
    return clip;
}

// A stream of four channels that plays on the second one.
struct Stream {
    Playback playback;
    std::vector<float> heard;  // on the second channel
    float elsewhere = 0.0F;    // the loudest on the others

    Stream() {
        playback.layout = {kRateHz, 4, 1, kCeiling};
        playback.level = 1.0F;
    }

    void run(std::size_t frames, std::size_t block = 240) {
        std::vector<float> buffer(4 * block, 9.0F);
        for (std::size_t done = 0; done < frames; done += block) {
            const std::size_t count = std::min(block, frames - done);
            render(playback, buffer.data(), count, static_cast<double>(heard.size()) / kRateHz);
            for (std::size_t n = 0; n < 4 * count; ++n) {
                if (n % 4 == 1) {
                    heard.push_back(buffer[n]);
                } else {
                    elsewhere = std::max(elsewhere, std::abs(buffer[n]));
                }
            }
        }
    }
};

inline double loudest(const std::vector<float>& samples, std::size_t from, std::size_t to) {
    double most = 0.0;
    for (std::size_t n = from; n < std::min(to, samples.size()); ++n) {
        most = std::max(most, std::abs(static_cast<double>(samples[n])));
    }
    return most;
}

}  // namespace playback_stream

}  // namespace tact
