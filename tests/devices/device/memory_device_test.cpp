#include "devices/device/memory_device.h"

#include <doctest/doctest.h>

namespace memory_device_test {

using namespace tact;

TEST_CASE("device: what is played is whole, and stops when told to") {
    MemoryDevice device(true);
    const Drive drive{1000.0, {0.0, 0.5, -0.5, 0.0}};
    REQUIRE(device.play(drive, true));
    CHECK(device.status().playing);
    REQUIRE(device.playing().has_value());
    CHECK(*device.playing() == drive);
    CHECK(device.looping());
    device.stop();
    CHECK_FALSE(device.status().playing);
}

TEST_CASE("device: without one, playing is refused with what to do") {
    MemoryDevice device(false);
    const auto answer = device.play(Drive{}, false);
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.find("plug in") != std::string::npos);
    CHECK_FALSE(device.status().connected);
}

}  // namespace memory_device_test
