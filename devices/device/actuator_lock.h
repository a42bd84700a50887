// That one program at a time drives an actuator: two of them add up beyond what either may send.
//
// Source    flock(2): the kernel lets go of it however the program ends
// Left out  other programs than this one, and other users of the computer; where no file can be
//           kept, nothing is locked.
#pragma once

#include <string>
#include <utility>

namespace tact {

// Of one actuator, while it lives.
class ActuatorLock {
  public:
    ActuatorLock() = default;
    // What an actuator is told apart by: its id, and its channel where it has some.
    explicit ActuatorLock(const std::string& actuator);
    ~ActuatorLock();
    ActuatorLock(ActuatorLock&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)), taken_(other.taken_) {}
    ActuatorLock& operator=(ActuatorLock&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        taken_ = other.taken_;
        return *this;
    }

    bool is_anothers() const { return taken_; }  // another program has it

  private:
    int descriptor_ = -1;
    bool taken_ = false;
};

}  // namespace tact
