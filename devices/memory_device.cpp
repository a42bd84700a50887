#include "devices/memory_device.h"

namespace tact {

Expected<Done> MemoryDevice::play(const Drive& drive, bool loop) {
    if (!connected_) return Error{"no device: plug in an actuator to feel the pattern"};
    playing_ = drive;
    loop_ = loop;
    return Done{};
}

DeviceStatus MemoryDevice::status() {
    DeviceStatus status;
    status.name = connected_ ? "memory" : "no device";
    status.connected = connected_;
    status.playing = playing_.has_value();
    return status;
}

}  // namespace tact
