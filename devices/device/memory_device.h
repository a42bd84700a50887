// A device that keeps what it was given: for tests, and in the place of "no device".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/device/device.h"

namespace tact {

class MemoryDevice final : public Device {
  public:
    // `connected` false: every play is refused, as without a device.
    explicit MemoryDevice(bool connected) : connected_(connected) {}

    Expected<Done> play(const Drive& drive, bool loop) override;
    // Begins when the test says that what plays has ended; the pause it takes no time for.
    Expected<Done> play_after(const Drive& drive, double rest_s) override;
    void change(const Drive& drive) override;
    void set_level(double level) override { level_ = level; }
    void stop() override { playing_.reset(), waiting_.reset(); }
    DeviceStatus status() override;

    // For a test to say how far it is, what it met, that it is lost: of its next statuses.
    void pretend(double position_s, double peak, bool clipped, const std::string& trouble = {});
    void end();
    void drop_out() { ++pretended_.dropouts; }

    // What is playing, and how, for a test to look at.
    const std::optional<Drive>& playing() const { return playing_; }
    bool looping() const { return loop_; }
    int begun() const { return begun_; }  // plays, without what they were changed into
    const std::vector<double>& rests_s() const { return rests_s_; }  // that were asked for
    double level() const { return level_; }

  private:
    bool connected_;
    bool loop_ = false;
    int begun_ = 0;
    double level_ = 1.0;
    std::optional<Drive> playing_;
    std::optional<Drive> waiting_;
    bool tells_end_ = false;  // by the next status, though the one that waited plays
    std::vector<double> rests_s_;
    DeviceStatus pretended_;
};

}  // namespace tact
