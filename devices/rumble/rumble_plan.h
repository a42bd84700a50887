// A drive signal as the frames that a controller is told one after the other.
//
// Left out  when each is sent (devices/hid/hid_device.h), and as which bytes
//           (devices/hid/hid_protocol.h)
// Exact     the frames depend on the signal, the language and the period alone
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "devices/rumble/actuator_kind.h"
#include "devices/rumble/motor_envelope.h"
#include "devices/rumble/two_band_tracking.h"

namespace tact {

class RumblePlan {
  public:
    // Frames each `period_s`. Samples that are no numbers are silence.
    RumblePlan(Drive drive, Language language, double period_s, double level = 1.0);

    std::size_t size() const { return size_; }

    // How strong the vibration is to be, as a share: strengths, of whatever language, are in
    // proportion to it. Fast enough between two frames of a minute.
    void set_level(double level);

    // Frame k at the level. Those of two bands are made when first asked for, which takes a
    // millisecond or some: less than the time until the next one.
    RumbleFrame rumble(std::size_t k);

    // What frame k of two bands makes of the signal, at level 1.
    const TrackedFrame& tracked(std::size_t k);

    const Drive& drive() const { return drive_; }

  private:
    std::vector<RumbleFrame> frames_at_level() const;

    Drive drive_;
    Language language_;
    double period_s_;
    double level_;
    std::size_t size_;
    std::vector<std::optional<TrackedFrame>> tracked_;  // of two bands ...
    Strengths strengths_;                               // ... and of all others
    std::vector<RumbleFrame> frames_;                   // of these, at the level
};

}  // namespace tact
