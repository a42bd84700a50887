// Esc stops the device at once, on the thread that notices the key first: a window that draws
// slowly, or hangs, must not keep an actuator running.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "devices/device/device.h"

namespace tact {

class EmergencyStop {
  public:
    // The device that plays now; null: none.
    void watch(std::shared_ptr<Device> device) {
        const std::lock_guard lock(mutex_);
        device_ = std::move(device);
    }

    // From any thread. In devices that play, Device::stop() uses atomics or a lock.
    void stop() {
        const std::lock_guard lock(mutex_);
        if (!device_) return;
        has_stopped_ = true;
        device_->stop();
    }

    // Whether a device was stopped since the last call.
    bool take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(has_stopped_, false);
    }

  private:
    std::mutex mutex_;
    std::shared_ptr<Device> device_;
    bool has_stopped_ = false;
};

}  // namespace tact
