#include "devices/memory_device.h"

namespace tact {

Expected<Done> MemoryDevice::play(const Waveform& waveform) {
    if (!connected_) return Error{"no device: plug in an actuator to feel the pattern"};
    playing_ = waveform;
    return Done{};
}

DeviceStatus MemoryDevice::status() const {
    return {connected_ ? "memory" : "no device", connected_, playing_.has_value(), 0.0};
}

}  // namespace tact
