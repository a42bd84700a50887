// A drive signal as the frames that a controller is told one after the other.
//
// Left out  when each is sent (devices/hid/hid_device.h), and as which bytes
// (devices/hid/hid_protocol.h). Exact     the frames depend on the signal, the language and the
// period alone.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "devices/rumble/actuator_kind.h"
#include "devices/rumble/two_band_tracking.h"

namespace tact {

class RumblePlan {
  public:
    // Frames each `period_s`. Samples that are no numbers are silence.
    RumblePlan(Drive drive, Language language, double period_s);

    std::size_t size() const { return size_; }

    // Frame k. Those of two bands are made when first asked for, which takes a millisecond or some:
    // less than the time until the next one.
    const TrackedFrame& frame(std::size_t k);

    const Drive& drive() const { return drive_; }

  private:
    Drive drive_;
    double period_s_;
    std::size_t size_;
    std::vector<std::optional<TrackedFrame>> frames_;
};

}  // namespace tact
