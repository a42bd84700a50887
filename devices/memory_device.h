// A device that keeps what it was given: for tests, and in the place of "no device".
#pragma once

#include <optional>

#include "devices/device.h"

namespace tact {

class MemoryDevice final : public Device {
  public:
    // `connected` false: every play is refused, as without a device.
    explicit MemoryDevice(bool connected) : connected_(connected) {}

    Expected<Done> play(const Waveform& waveform) override;
    void stop() override { playing_.reset(); }
    DeviceStatus status() const override;

    // What is playing, for a test to look at.
    const std::optional<Waveform>& playing() const { return playing_; }

  private:
    bool connected_;
    std::optional<Waveform> playing_;
};

}  // namespace tact
