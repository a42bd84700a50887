#include "devices/phone/phone_device.h"

#include <doctest/doctest.h>

#include <cmath>
#include <mutex>
#include <thread>

#include "devices/phone/on_off_times.h"
#include "tests/support/comes_true.h"

namespace phone_device_test {

using namespace tact;
using Clock = std::chrono::steady_clock;

namespace {

// What a room of phones was told, and when.
struct Room {
    std::mutex mutex;
    std::vector<PhonePlay> plays;
    std::vector<Clock::time_point> times;
    std::vector<ConnectedPhone> phones{{1, "Kim", "en", true, true, PhoneSide::both, {}}};

    PhoneDoor door() {
        return {[this](PhonePlay play) {
                    const std::lock_guard lock(mutex);
                    plays.push_back(std::move(play));
                    times.push_back(Clock::now());
                },
                [this] {
                    const std::lock_guard lock(mutex);
                    return phones;
                }};
    }
    std::size_t count() {
        const std::lock_guard lock(mutex);
        return plays.size();
    }
    PhonePlay play(std::size_t k) {
        const std::lock_guard lock(mutex);
        return plays.at(k);
    }
    double time_between(std::size_t first, std::size_t second) {
        const std::lock_guard lock(mutex);
        return std::chrono::duration<double>(times.at(second) - times.at(first)).count();
    }
};

Drive buzz(double seconds) {
    Drive drive;
    drive.rate_hz = 1000.0;
    drive.samples.assign(static_cast<std::size_t>(std::lround(1000.0 * seconds)), 1.0);
    return drive;
}

}  // namespace

TEST_CASE("phone device: without a phone that vibrates it says what to do") {
    Room room;
    room.phones[0].vibrates = false;
    PhoneDevice device(room.door());
    const auto played = device.play(buzz(0.1), false);
    REQUIRE_FALSE(played);
    CHECK(played.error().message == kNoPhone);
    CHECK(device.status().trouble == kNoPhone);
    CHECK_FALSE(device.status().connected);
    CHECK(device.status().name == "Phones");
    room.phones[0].vibrates = true;
    CHECK(device.status().connected);
    CHECK(device.status().trouble.empty());
    room.phones[0].side = PhoneSide::b;
    device.set_side(PhoneSide::a);
    CHECK_FALSE(device.status().connected);
    CHECK(room.count() == 0);
}

TEST_CASE("phone device: without a thread it does what is due when it is asked for its status") {
    Room room;
    PhoneDoor door = room.door();
    door.has_thread = false;
    {
        PhoneDevice device(std::move(door));
        REQUIRE(device.play(buzz(0.05), false));
        CHECK(room.count() == 0);
        CHECK(device.status().playing);
        REQUIRE(room.count() == 1);
        CHECK(length_ms(room.play(0).ms) == 50);
        CHECK(comes_true([&] { return !device.status().playing; }));
        CHECK(room.count() == 1);
        REQUIRE(device.play(buzz(10.0), true));
        CHECK(device.status().playing);
    }
    REQUIRE(room.count() == 3);
    CHECK(room.play(2).ms.empty());  // it stops with its device
}

TEST_CASE("phone device: a play goes out once, and ends by the clock") {
    Room room;
    PhoneDevice device(room.door());
    REQUIRE(device.play(buzz(0.06), false));
    CHECK(device.status().playing);
    CHECK(comes_true([&] { return !device.status().playing; }));
    CHECK(room.count() == 1);
    CHECK(length_ms(room.play(0).ms) == 60);
    CHECK_FALSE(room.play(0).loop);
    CHECK(device.status().position_s == doctest::Approx(0.06));
}

TEST_CASE("phone device: a loop is as long as its drive, and a stop is told") {
    Room room;
    PhoneDevice device(room.door(), PhoneSide::b);
    Drive drive = buzz(0.05);
    drive.samples.resize(80, 0.0);
    REQUIRE(device.play(drive, true));
    CHECK(comes_true([&] { return room.count() == 1; }));
    CHECK(room.play(0) == PhonePlay{{50, 30}, true, PhoneSide::b});
    device.stop();
    CHECK(room.count() == 2);
    CHECK(room.play(1) == PhonePlay{{}, false, PhoneSide::b});
    CHECK_FALSE(device.status().playing);
    device.stop();
    CHECK(room.count() == 2);
}

TEST_CASE("phone device: what follows begins its rest after the end, whoever looks" *
          doctest::test_suite("long")) {
    Room room;
    PhoneDevice device(room.door());
    REQUIRE(device.play(buzz(0.12), false));
    REQUIRE(device.play_after(buzz(0.05), 0.1));
    REQUIRE(device.play_after(buzz(0.07), 0.0));
    CHECK(comes_true([&] { return room.count() == 3; }));
    CHECK(length_ms(room.play(1).ms) == 50);
    CHECK(length_ms(room.play(2).ms) == 70);
    // Never early; how late is the system's, and what is late is not added up.
    CHECK(room.time_between(0, 1) >= 0.215);
    CHECK(room.time_between(0, 2) >= 0.265);
    CHECK_FALSE(device.status().playing);  // the end of the first one is told once
    CHECK(comes_true([&] { return !device.status().playing; }));
}

TEST_CASE("phone device: a level and a changed loop are sent from where the play is" *
          doctest::test_suite("long")) {
    Room room;
    PhoneDevice device(room.door());
    Drive drive = buzz(0.5);
    drive.samples.resize(1000, 0.0);
    REQUIRE(device.play(drive, true));
    CHECK(comes_true([&] { return room.count() == 1; }));
    Drive other = buzz(0.25);
    other.samples.resize(1000, 0.0);
    device.change(other);
    CHECK(comes_true([&] { return room.count() == 2; }));
    const PhonePlay changed = room.play(1);
    CHECK(changed.loop);
    CHECK(length_ms(changed.ms) == 1000);
    CHECK(changed.ms != std::vector{250, 750});  // turned: 0.1 s of it were over
    CHECK(room.time_between(0, 1) >= 0.09);      // no more often
    device.set_level(0.0);
    CHECK(comes_true([&] { return room.count() == 3; }));
    CHECK(room.play(2).ms.empty());
    CHECK(device.status().playing);
    device.set_level(2.0);
    CHECK(comes_true([&] { return room.count() == 4; }));
    CHECK(length_ms(room.play(3).ms) == 1000);
    device.stop();
}

TEST_CASE("phone device: a largest level and a longest time hold" * doctest::test_suite("long")) {
    Room room;
    PhoneDevice device(room.door());
    Drive drive = buzz(10.0);
    drive.longest_s = 0.1;
    REQUIRE(device.play(drive, true));
    CHECK(comes_true([&] { return !device.status().playing; }));
    CHECK(room.count() == 2);
    CHECK(room.play(1).ms.empty());
    drive.largest_level = 0.01;
    REQUIRE(device.play(drive, false));
    CHECK(comes_true([&] { return room.count() >= 3; }));
    CHECK(room.play(2).ms.empty());
    CHECK(device.status().clipped);
}

TEST_CASE("phone device: it ends silently, and plays of one side leave the other") {
    Room room;
    {
        PhoneDevice device(room.door(), PhoneSide::a);
        REQUIRE(device.play(buzz(5.0), true));
        CHECK(comes_true([&] { return room.count() == 1; }));
        device.set_side(PhoneSide::b);
        REQUIRE(device.play(buzz(5.0), true));
        CHECK(comes_true([&] { return room.count() == 3; }));
        CHECK(room.play(1) == PhonePlay{{}, false, PhoneSide::a});
        CHECK(room.play(2).side == PhoneSide::b);
        CHECK(device.status().peak <= 1.0);
    }
    CHECK(room.play(room.count() - 1).ms.empty());
}

}  // namespace phone_device_test
