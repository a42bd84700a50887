#include "devices/hid/hid_device.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/support/fake_pad.h"
#include "tests/support/places.h"

namespace hid_device_test {

using namespace tact;
using namespace tact::fake_pad;

namespace {

// The five neutral packets follow each other by a period.
void wait_for_neutral(const std::shared_ptr<FakePad>& pad) {
    const Packet neutral = switch_rumble(0, {});
    CHECK(soon([&] {
        const auto packets = pad->taken();
        if (packets.size() < kNeutralPackets) return false;
        return std::all_of(packets.end() - kNeutralPackets, packets.end(), [&](const Packet& p) {
            return std::equal(p.begin() + 2, p.end(), neutral.begin() + 2, neutral.end());
        });
    }));
}

bool is_rumble(const Packet& packet) { return packet[0] == 0x10; }

}  // namespace

TEST_CASE(
    "hid: a pad on a cable is woken, its vibration switched on, and then rumble alone is sent" *
    doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::usb));
    REQUIRE(device.play(tone(0.2), false));
    CHECK(ended(device));
    wait_for_neutral(pad);
    const auto packets = pad->taken();
    REQUIRE(packets.size() > 10);
    for (std::size_t k = 0; k < 4; ++k) CHECK(packets[k] == switch_usb(kSwitchUsbCommands[k]));
    CHECK(packets[4] == switch_subcommand(0, {}, kEnableVibration, 1));
    CHECK(std::all_of(packets.begin() + 5, packets.end(), is_rumble));
    RumbleFrame frame;
    frame.low = 0.5;
    CHECK(
        std::equal(packets[6].begin() + 2, packets[6].end(), switch_rumble(0, frame).begin() + 2));
    CHECK(pad->emergency_packet == switch_rumble(0, {}));
    CHECK(device.status().trouble.empty());
}

TEST_CASE("hid: a loop that is changed goes on in its next packet, without a pause") {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::bluetooth));
    const auto tells = [](double low) {
        RumbleFrame frame;
        frame.low = low;
        const Packet packet = switch_rumble(0, frame);
        return [packet](const Packet& sent) {
            return is_rumble(sent) && std::equal(sent.begin() + 2, sent.end(), packet.begin() + 2);
        };
    };
    REQUIRE(device.play(tone(0.5), true));
    CHECK(soon([&] { return std::ranges::any_of(pad->taken(), tells(0.5)); }));
    Drive weaker = tone(0.3);
    for (double& sample : weaker.samples) sample *= 0.5;
    device.change(weaker);
    CHECK(soon([&] { return std::ranges::any_of(pad->taken(), tells(0.25)); }));
    CHECK(device.status().playing);
    CHECK(std::ranges::none_of(pad->taken(), tells(0.0)));
    device.stop();
    CHECK(ended(device));
    device.change(tone(0.5));  // of what has ended
    CHECK_FALSE(device.status().playing);
    wait_for_neutral(pad);
}

TEST_CASE("hid: counters go up by one a packet" * doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    Drive drive = tone(0.5);
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        drive.samples[n] *= static_cast<double>(n) / static_cast<double>(drive.samples.size());
    }
    REQUIRE(device.play(drive, false));
    CHECK(ended(device));
    wait_for_neutral(pad);
    std::vector<int> counters;
    for (const Packet& packet : pad->taken()) {
        if (is_rumble(packet)) counters.push_back(packet[1]);
    }
    REQUIRE(counters.size() > 15);
    for (std::size_t k = 1; k < counters.size(); ++k) {
        CHECK(counters[k] == (counters[k - 1] + 1) % 16);
    }
}

TEST_CASE("hid: a steady tone is repeated every 50 ms or so, and no sooner" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    REQUIRE(device.play(tone(0.6), false));
    CHECK(ended(device));
    const std::lock_guard lock(pad->mutex);
    std::vector<PadClock::time_point> times;
    for (std::size_t k = 0; k < pad->packets.size(); ++k) {
        if (pad->packets[k][0] == 0x10) times.push_back(pad->times[k]);
    }
    // 0.6 s at a packet every second period of 30 ms.
    CHECK(times.size() >= 8);
    CHECK(times.size() <= 13 + kNeutralPackets);
    for (std::size_t k = 1; k + kNeutralPackets < times.size(); ++k) {
        CHECK(times[k] - times[k - 1] >= std::chrono::milliseconds(45));
    }
}

TEST_CASE("hid: stop silences at once, also a loop" * doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::usb));
    REQUIRE(device.play(tone(0.1), true));
    REQUIRE(soon([&] { return pad->taken().size() > 15; }));
    CHECK(device.status().playing);
    CHECK(device.status().position_s <= 0.1);
    const auto asked = PadClock::now();
    device.stop();
    const Packet neutral = switch_rumble(0, {});
    REQUIRE(soon([&] {
        const Packet last = pad->taken().back();
        return std::equal(last.begin() + 2, last.end(), neutral.begin() + 2);
    }));
    CHECK(PadClock::now() - asked < std::chrono::milliseconds(200));  // 20 on an idle machine
    CHECK(ended(device));
    wait_for_neutral(pad);
}

TEST_CASE("hid: the device is silenced when it is given up in the middle of a play" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    {
        HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
        REQUIRE(device.play(tone(5.0), false));
        REQUIRE(soon([&] { return pad->taken().size() > 3; }));
    }
    wait_for_neutral(pad);
}

TEST_CASE("hid: level nought is neutral, and half of it half as strong" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    device.set_level(0.5);
    REQUIRE(device.play(tone(0.2), false));
    double peak = 0.0;
    CHECK(soon([&] {
        const DeviceStatus status = device.status();
        peak = std::max(peak, status.peak);
        return !status.playing;
    }));
    CHECK(std::abs(peak - 0.25) <= 0.01);
    CHECK(device.status().peak == 0.0);
    RumbleFrame half;
    half.low = 0.25;
    const auto packets = pad->taken();
    REQUIRE(packets.size() > 3);
    CHECK(std::equal(packets[2].begin() + 2, packets[2].end(), switch_rumble(0, half).begin() + 2));
    wait_for_neutral(pad);
    device.set_level(0.0);
    REQUIRE(device.play(tone(0.2), false));
    CHECK(ended(device));
    const auto all = pad->taken();
    for (std::size_t k = packets.size(); k < all.size(); ++k) {
        const Packet neutral = switch_rumble(0, {});
        CHECK(std::equal(all[k].begin() + 2, all[k].end(), neutral.begin() + 2));
    }
}

TEST_CASE(
    "hid: a level that is raised at once rises within a fifth of a second, and falls at once" *
    doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    device.set_level(0.1);
    REQUIRE(device.play(tone(1.0), true));
    REQUIRE(soon([&] { return pad->taken().size() > 8; }));
    const auto peak_within = [&](double low, double high) {
        return soon([&] {
            const double peak = device.status().peak;
            return peak > low && peak < high;
        });
    };
    // A thread that had to wait for the processor may miss what lies between, but not each time.
    const bool rises = soon([&] {
        device.set_level(0.1);
        REQUIRE(peak_within(0.0, 0.06));
        device.set_level(1.0);
        bool is_between = false;
        REQUIRE(soon([&] {
            const double peak = device.status().peak;
            is_between = is_between || (peak > 0.1 && peak < 0.4);
            return peak > 0.48;
        }));
        return is_between;
    });
    CHECK(rises);
    device.stop();
    CHECK(ended(device));
}

TEST_CASE("hid: one that is unplugged is noticed, says so, and is refused until it is back" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidActuator which = actuator(ActuatorKind::joy_con, HidBus::bluetooth);
    HidDevice device = device_on(pad, which);
    REQUIRE(device.play(tone(5.0), false));
    REQUIRE(soon([&] { return pad->taken().size() > 3; }));
    {
        const std::lock_guard lock(pad->mutex);
        pad->is_there = false;
    }
    CHECK(ended(device));
    CHECK(device.status().trouble == "the pad was unplugged, or is out of reach");
    CHECK_FALSE(device.status().connected);
    CHECK(device.play(tone(0.1), false).error().message == device.status().trouble);
    {
        const std::lock_guard lock(pad->mutex);
        pad->is_there = true;
    }
    CHECK(soon([&] { return device.status().connected; }));
    CHECK(device.play(tone(0.1), false));
    CHECK(ended(device));
    wait_for_neutral(pad);
    CHECK(device.status().trouble.empty());
}

TEST_CASE("hid: one that does not confirm its vibration is said not to answer" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    pad->answers_at_all = false;
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    REQUIRE(device.play(tone(0.1), false));
    CHECK(ended(device));
    CHECK(device.status().trouble == "the pad does not answer: disconnect it and connect it again");
    for (const Packet& packet : pad->taken()) CHECK_FALSE(is_rumble(packet));
}

TEST_CASE("hid: where the kernel's driver has the pad, nothing but rumble is sent") {
    const auto pad = std::make_shared<FakePad>();
    pad->answers_at_all = false;
    HidActuator which = actuator(ActuatorKind::switch_pro, HidBus::usb);
    which.kernel_driver = "nintendo";
    HidDevice device = device_on(pad, which);
    REQUIRE(device.play(tone(0.1), false));
    CHECK(ended(device));
    wait_for_neutral(pad);
    for (const Packet& packet : pad->taken()) CHECK(is_rumble(packet));
}

TEST_CASE("hid: a node that is not there, and one without permission, say what to do") {
    HidActuator which = actuator(ActuatorKind::joy_con, HidBus::bluetooth);
    which.path = "/dev/hidraw none";
    CHECK(may_be_opened(which).error().message ==
          "the pad is not there any more: connect it again");
    HidDevice device(which);
    CHECK(device.play(tone(0.1), false));
    CHECK(ended(device));
    CHECK_FALSE(device.status().connected);
    CHECK_FALSE(device.play(tone(0.1), false));
    CHECK_FALSE(open_hid_port("/dev/null"));  // a character device, but none of HID
}

TEST_CASE("hid: the rules that the program names are those of the file it comes with") {
    std::ifstream file(std::string(kAssetsDir) + "/70-tactspace.rules");
    std::stringstream text;
    text << file.rdbuf();
    HidActuator which;
    for (const std::uint16_t vendor : {std::uint16_t{0x057e}, std::uint16_t{0x054c}}) {
        which.vendor = vendor;
        for (const HidBus bus : {HidBus::usb, HidBus::bluetooth}) {
            which.bus = bus;
            CHECK(text.str().find("\n" + udev_rule(which) + "\n") != std::string::npos);
        }
    }
}

TEST_CASE("hid: an empty pattern, and one of no numbers, play silence") {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::usb));
    REQUIRE(device.play(Drive{}, true));
    CHECK(ended(device));
    REQUIRE(device.play(Drive{kModelRateHz, std::vector<double>(500, std::nan(""))}, false));
    CHECK(ended(device));
    wait_for_neutral(pad);
    const Packet neutral = switch_rumble(0, {});
    for (const Packet& packet : pad->taken()) {
        if (is_rumble(packet)) {
            CHECK(std::equal(packet.begin() + 2, packet.end(), neutral.begin() + 2));
        }
    }
}

TEST_CASE(
    "hid: two programs do not send to one controller: the second is told, and its turn comes" *
    doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    const HidActuator which = actuator(ActuatorKind::joy_con, HidBus::bluetooth);
    std::atomic<bool> is_taken = true;
    HidPorts ports;
    ports.list = [which] { return std::vector{which}; };
    ports.may_be_opened = [](const HidActuator&) -> Expected<Done> { return Done{}; };
    ports.open = [pad](const std::string&) { return port_of(pad); };
    ports.claim = [&is_taken, which](const HidActuator& asked) -> Expected<ActuatorLock> {
        CHECK(asked == which);
        return is_taken ? Expected<ActuatorLock>(Error{"it is another's"}) : ActuatorLock();
    };
    HidDevice device(which, ports);
    REQUIRE(device.play(tone(0.1), false));
    CHECK(ended(device));
    CHECK(device.status().trouble == "it is another's");
    CHECK(device.status().connected);
    CHECK(pad->taken().empty());
    is_taken = false;
    REQUIRE(device.play(tone(0.1), false));
    CHECK(ended(device));
    CHECK(device.status().trouble.empty());
    wait_for_neutral(pad);
}

TEST_CASE("hid: a loop, and a long pattern, play no longer on end than the drive may" *
          doctest::test_suite("long")) {
    for (const bool loop : {true, false}) {
        CAPTURE(loop);
        const auto pad = std::make_shared<FakePad>();
        HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::usb));
        Drive drive = tone(loop ? 0.05 : 3600.0);
        drive.longest_s = 0.2;
        REQUIRE(device.play(drive, loop));
        REQUIRE(ended(device));
        CHECK(device.status().position_s <= 0.2);
        wait_for_neutral(pad);
        const std::lock_guard lock(pad->mutex);
        // 5 that wake it, and no more frames than 0.2 s hold, first and last one included.
        CHECK(pad->packets.size() <= 5 + kNeutralPackets + 14);
    }
}

TEST_CASE("hid: no level is larger than the drive bears, and that is told" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    Drive drive = tone(0.2);
    drive.largest_level = 0.5;
    const auto peak_at = [&](double level) {
        device.set_level(level);
        REQUIRE(device.play(drive, false));
        double peak = 0.0;
        REQUIRE(soon([&] {
            const DeviceStatus status = device.status();
            peak = std::max(peak, status.peak);
            return !status.playing;
        }));
        return peak;
    };
    const double most = peak_at(1.0);
    CHECK(std::abs(most - 0.25) <= 0.01);  // half of 0.5
    CHECK(device.status().clipped);
    CHECK(peak_at(0.5) == most);
    CHECK_FALSE(device.status().clipped);
}

TEST_CASE("hid: what a loop becomes plays no longer than that may, from its own beginning on" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::bluetooth));
    REQUIRE(device.play(tone(0.1), true));
    REQUIRE(soon([&] { return pad->taken().size() > 2; }));
    Drive shorter = tone(0.1);
    shorter.longest_s = 0.3;
    const auto begun = PadClock::now();
    device.change(shorter);
    CHECK(ended(device));
    CHECK(PadClock::now() - begun < std::chrono::milliseconds(1500));  // a loop would never end
    CHECK_FALSE(device.status().is_warm);
    // The other way round it continues.
    REQUIRE(device.play(shorter, true));
    device.change(tone(0.1));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    CHECK(device.status().playing);
    device.stop();
    CHECK(ended(device));
}

TEST_CASE("hid: a change is no stronger than what it becomes may be, from its first packet on" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::bluetooth));
    REQUIRE(device.play(tone(0.3), true));
    REQUIRE(soon([&] { return device.status().peak > 0.4; }));
    Drive weak = tone(0.3);
    weak.largest_level = 0.2;
    device.change(weak);
    REQUIRE(soon([&] { return device.status().clipped; }));
    (void)device.status();  // the peak since then
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(device.status().peak <= 0.11);
    device.stop();
    CHECK(ended(device));
}

TEST_CASE("hid: plays in turn get an actuator as warm as a loop does, and that ends them" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::switch_pro, HidBus::bluetooth));
    Drive drive = tone(0.3);
    drive.rest_after_s = 0.7;
    int whole = 0;
    for (; whole < 10; ++whole) {
        REQUIRE(device.play(drive, false));
        REQUIRE(ended(device));
        if (device.status().is_warm) break;
    }
    CHECK(whole >= 1);
    CHECK(whole <= 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    REQUIRE(device.play(drive, false));
    REQUIRE(ended(device));
    CHECK_FALSE(device.status().is_warm);
}

}  // namespace hid_device_test
