#include "devices/device/memory_device.h"

#include <utility>

namespace tact {

Expected<Done> MemoryDevice::play(const Drive& drive, bool loop) {
    if (!connected_) return Error{"no device: plug in an actuator to feel the pattern"};
    playing_ = drive;
    waiting_.reset();
    loop_ = loop;
    ++begun_;
    return Done{};
}

Expected<Done> MemoryDevice::play_after(const Drive& drive, double rest_s) {
    rests_s_.push_back(rest_s);
    if (!playing_) return play(drive, false);
    waiting_ = drive;
    return Done{};
}

void MemoryDevice::end() {
    playing_.reset();
    tells_end_ = waiting_.has_value();
    if (waiting_) (void)play(*std::exchange(waiting_, std::nullopt), false);
}

void MemoryDevice::change(const Drive& drive) {
    if (playing_ && loop_) playing_ = drive;
}

DeviceStatus MemoryDevice::status() {
    DeviceStatus status = pretended_;
    status.name = connected_ ? "memory" : "no device";
    status.connected = connected_;
    status.playing = playing_.has_value() && !std::exchange(tells_end_, false);
    return status;
}

void MemoryDevice::pretend(double position_s, double peak, bool clipped,
                           const std::string& trouble) {
    pretended_.position_s = position_s;
    pretended_.peak = peak;
    pretended_.clipped = clipped;
    pretended_.trouble = trouble;
}

}  // namespace tact
