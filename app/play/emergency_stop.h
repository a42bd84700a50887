// What Esc stops at once, on whichever thread the key is noticed first: a window that draws slowly,
// or hangs, must not keep an actuator going.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "devices/device/device.h"

namespace tact {

class EmergencyStop {
  public:
    // What sounds now; null: nothing does.
    void watch(std::shared_ptr<Device> device) {
        const std::lock_guard lock(mutex_);
        device_ = std::move(device);
    }

    // From any thread. Device::stop() is one of atomics or under a lock in devices that play.
    void stop() {
        const std::lock_guard lock(mutex_);
        if (!device_) return;
        has_stopped_ = true;
        device_->stop();
    }

    // Whether something was stopped since this was asked last.
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
