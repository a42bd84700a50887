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

TEST_CASE("device: a loop becomes what it is changed into; a single play and silence do not") {
    MemoryDevice device(true);
    const Drive drive{1000.0, {0.0, 0.5, -0.5, 0.0}};
    const Drive other{1000.0, {0.0, 0.25}};
    device.change(other);
    CHECK_FALSE(device.playing());
    REQUIRE(device.play(drive, false));
    device.change(other);
    CHECK(*device.playing() == drive);
    REQUIRE(device.play(drive, true));
    device.change(other);
    CHECK(*device.playing() == other);
    CHECK(device.begun() == 2);
}

TEST_CASE("device: without one, playing is refused with what to do") {
    MemoryDevice device(false);
    const auto answer = device.play(Drive{}, false);
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.find("plug in") != std::string::npos);
    CHECK_FALSE(device.status().connected);
}

}  // namespace memory_device_test
