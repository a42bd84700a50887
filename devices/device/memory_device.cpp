#include "devices/device/memory_device.h"

namespace tact {

Expected<Done> MemoryDevice::play(const Drive& drive, bool loop) {
    if (!connected_) return Error{"no device: plug in an actuator to feel the pattern"};
    playing_ = drive;
    loop_ = loop;
    ++begun_;
    return Done{};
}

void MemoryDevice::change(const Drive& drive) {
    if (playing_ && loop_) playing_ = drive;
}

DeviceStatus MemoryDevice::status() {
    DeviceStatus status = pretended_;
    status.name = connected_ ? "memory" : "no device";
    status.connected = connected_;
    status.playing = playing_.has_value();
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
