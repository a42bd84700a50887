#include "devices/memory_device.h"

#include <doctest/doctest.h>

#include "model/pattern.h"

using namespace tact;

TEST_CASE("device: what is played is whole, and stops when told to") {
    MemoryDevice device(true);
    const Waveform waveform = render(Pattern{});
    REQUIRE(device.play(waveform));
    CHECK(device.status().playing);
    REQUIRE(device.playing().has_value());
    CHECK(*device.playing() == waveform);
    device.stop();
    CHECK_FALSE(device.status().playing);
}

TEST_CASE("device: without one, playing is refused with what to do") {
    MemoryDevice device(false);
    const auto answer = device.play(render(Pattern{}));
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.find("plug in") != std::string::npos);
    CHECK_FALSE(device.status().connected);
}
