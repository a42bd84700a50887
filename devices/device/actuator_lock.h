// That one program at a time drives an actuator: two of them add up beyond what either may send, or
// take turns packet by packet.
//
// Source    flock(2): the kernel lets go of it however the program ends
// Left out  other programs than this one, and other users of the computer; where no file can be
//           kept, nothing is locked.
#pragma once

#include <string>
#include <utility>

#include "model/common/expected.h"

namespace tact {

// Locks one actuator while it lives; default: none.
class ActuatorLock {
  public:
    ActuatorLock() = default;
    ~ActuatorLock();
    ActuatorLock(ActuatorLock&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)) {}
    ActuatorLock& operator=(ActuatorLock&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }

    // `id` is what an actuator is told apart by, with its channel where it has some; `name` what a
    // person calls it. An Error while another has it.
    static Expected<ActuatorLock> of(const std::string& id, const std::string& name);

  private:
    int descriptor_ = -1;
};

}  // namespace tact
