// What an actuator on the only channel of an output gets, play after play.
#pragma once

#include <cstdint>
#include <vector>

#include "devices/device/playback.h"
#include "model/signal/waveform.h"

namespace tact::one_channel {

struct Out {
    Playback playback;
    std::vector<float> left;
    std::vector<Clip> clips;
    std::uint64_t serial = 0;

    double rate_hz;
    std::size_t block;

    Out(double of_rate_hz, std::size_t of_block) : rate_hz(of_rate_hz), block(of_block) {
        playback.layout = {rate_hz, 1, 0, kCeiling};
        playback.level = 1.0F;
        clips.reserve(200);
    }
    void run(double seconds) {
        std::vector<float> buffer(block);
        const std::size_t until = left.size() + sample_count(seconds, rate_hz);
        while (left.size() < until) {
            render(playback, buffer.data(), buffer.size(),
                   static_cast<double>(left.size()) / rate_hz);
            left.insert(left.end(), buffer.begin(), buffer.end());
        }
    }
    void play(const Drive& drive, bool loop = false) {
        clips.push_back(clip_of(drive, rate_hz, loop));
        clips.back().serial = ++serial;
        playback.wanted = &clips.back();
    }
    void change(const Drive& drive) {
        clips.push_back(clip_of(drive, rate_hz, true));
        clips.back().serial = serial;
        playback.wanted = &clips.back();
    }
    void run_to_its_end() {
        while (playback.ended < serial) run(0.005);
    }
};

}  // namespace tact::one_channel
