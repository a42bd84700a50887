// Controllers through the real hidapi, on devices that umockdev makes: run by umockdev-wrapper.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <memory>
#include <numbers>

#include "devices/hid/emergency_packet.h"
#include "devices/hid/haptic_page.h"
#include "devices/hid/hid_device.h"
#include "tests/support/comes_true.h"
#include "tests/support/haptic_descriptor.h"
#include "tests/umockdev/pads.h"

using namespace tact;

namespace {

MockPad mouse() { return {"hidraw5", false, 0x046d, 0xc077, "Mouse", "hid-generic"}; }

HidActuator listed(const std::string& name) {
    for (const HidActuator& actuator : hid_actuators()) {
        if (actuator.name == name) return actuator;
    }
    FAIL("not listed: " << name);
    return {};
}

// From 60 to 300 Hz in a second, louder and louder: no two frames alike.
Drive sweep() {
    Drive drive;
    for (std::size_t n = 0; n < 10'000; ++n) {
        const double t_s = static_cast<double>(n) / kModelRateHz;
        const double phase = 2.0 * std::numbers::pi * (60.0 * t_s + 120.0 * t_s * t_s);
        drive.samples.push_back((0.2 + 0.6 * t_s) * std::sin(phase));
    }
    return drive;
}

// Plays, and waits for the end with its neutral packets.
void play_through(HidDevice& device, const Drive& drive) {
    REQUIRE(device.play(drive, false));
    CHECK(comes_true([&] { return !device.status().playing; }));
    CHECK(device.status().trouble == "");
}

// Written as from `first`: the frames of the plan, in their order, each changed one once; a frame
// whose time was over may be missing. Then five neutral ones.
void check_packets(const std::vector<Written>& written, std::size_t first, RumblePlan plan,
                   const Encoder& encode, const SendStatistics& statistics) {
    std::vector<Packet> expected;
    for (std::size_t k = 0; k < plan.size(); ++k) {
        expected.push_back(encode(plan.rumble(k), 0));
    }
    const Packet neutral = encode(RumbleFrame{}, 0);
    const auto plain = [](Packet packet) {  // without what counts up, and its checksum
        if (packet[0] == 0x10 || packet[0] == 0x31) packet[1] = 0;
        if (packet[0] == 0x31) packet.resize(packet.size() - 4);
        return packet;
    };
    REQUIRE(written.size() >= first + kNeutralPackets);
    const std::size_t end = written.size() - kNeutralPackets;
    std::size_t at = 0;
    std::size_t found = 0;
    for (std::size_t k = first; k < end; ++k) {
        while (at < expected.size() && plain(expected[at]) != plain(written[k].packet)) ++at;
        CAPTURE(k);
        REQUIRE_MESSAGE(at < expected.size(), "a packet that is not the plan's, or out of order");
        ++found;
    }
    std::vector<Packet> different = expected;
    different.erase(std::ranges::unique(different).begin(), different.end());
    CHECK(found + statistics.skipped >= different.size());
    for (std::size_t k = end; k < written.size(); ++k) {
        CHECK(plain(written[k].packet) == plain(neutral));
    }
}

// How long after its deadline each packet arrived; prints what is asked for most.
void check_pace(const SendStatistics& statistics) {
    MESSAGE(statistics.sent << " packets, lateness: median " << 1e3 * statistics.median_late_s
                            << " ms, 99 % below " << 1e3 * statistics.p99_late_s << " ms, worst "
                            << 1e3 * statistics.worst_late_s << " ms, skipped "
                            << statistics.skipped);
    // On an idle machine a tenth of a millisecond. With a sanitizer, which makes the tracking
    // twenty times slower, every second frame is skipped, and those that are sent are no period
    // late.
    CHECK(statistics.skipped <= 2 * statistics.sent);
    CHECK(statistics.median_late_s < 0.1);
}

}  // namespace

TEST_CASE("umockdev: every controller is listed with what it is, and a mouse is none") {
    const MockBench bench({joy_con(), pro(), dualshock(), dualsense(), knob(), mouse()});
    const auto found = hid_actuators();
    REQUIRE(found.size() == 5);
    CHECK(found[0].name == "DualSense");
    CHECK(found[1].name == "DualShock 4");
    CHECK(found[2].name == "Haptic knob");
    CHECK(found[3].name == "Joy-Con (L)");
    CHECK(found[4].name == "Switch Pro Controller");
    CHECK(found[0].kind == ActuatorKind::dualsense);
    CHECK(found[2].kind == ActuatorKind::simple_haptic);
    CHECK(found[3].bus == HidBus::bluetooth);
    CHECK(found[4].bus == HidBus::usb);
    CHECK(found[1].kernel_driver == "sony");
    CHECK(found[3].path == "/dev/hidraw0");
    CHECK(lasting_id(found[3]) == "hid:057e:2006:98:b6:e9:00:00:00");
}

TEST_CASE(
    "umockdev: a Joy-Con's vibration is enabled, and every packet comes in order and in time") {
    const MockBench bench({joy_con()});
    const HidActuator actuator = listed("Joy-Con (L)");
    SendStatistics statistics;
    {
        HidDevice device(actuator);
        play_through(device, sweep());
        statistics = device.statistics();
    }
    const auto written = bench.written("hidraw0");
    REQUIRE(written.size() > 8);
    CHECK(written[0].packet == switch_subcommand(0, {}, kEnableVibration, 1));
    const Encoder encode = [](const RumbleFrame& f, int counter) {
        return switch_rumble(counter, f);
    };
    check_packets(written, 1, {sweep(), Language::two_bands, 1.02 * 0.030}, encode, statistics);
    for (std::size_t k = 2; k < written.size(); ++k) {
        CHECK(written[k].packet[1] == (written[k - 1].packet[1] + 1) % 16);
    }
    check_pace(statistics);
}

TEST_CASE(
    "umockdev: a Pro Controller on its cable is woken first, and packets come twice as often") {
    const MockBench bench({pro()});
    SendStatistics statistics;
    {
        HidDevice device(listed("Switch Pro Controller"));
        play_through(device, sweep());
        statistics = device.statistics();
    }
    const auto written = bench.written("hidraw1");
    REQUIRE(written.size() > 10);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(written[k].packet == switch_usb(kSwitchUsbCommands[k]));
    CHECK(written[4].packet == switch_subcommand(0, {}, kEnableVibration, 1));
    const Encoder encode = [](const RumbleFrame& f, int counter) {
        return switch_rumble(counter, f);
    };
    check_packets(written, 5, {sweep(), Language::two_bands, 1.02 * 0.015}, encode, statistics);
    check_pace(statistics);
}

TEST_CASE("umockdev: a DualShock 4 by Bluetooth and a DualSense on its cable play their motors") {
    const MockBench bench({dualshock(), dualsense()});
    SendStatistics of_dualshock;
    SendStatistics of_dualsense;
    {
        HidDevice first(listed("DualShock 4"));
        HidDevice second(listed("DualSense"));
        REQUIRE(first.play(sweep(), false));  // both at a time
        play_through(second, sweep());
        CHECK(comes_true([&] { return !first.status().playing; }));
        of_dualshock = first.statistics();
        of_dualsense = second.statistics();
    }
    check_packets(
        bench.written("hidraw2"), 0, {sweep(), Language::motor_pair, 1.02 * 0.020},
        [](const RumbleFrame& frame, int) { return dualshock4_bluetooth(frame); }, of_dualshock);
    check_packets(
        bench.written("hidraw3"), 0, {sweep(), Language::motor_pair, 1.02 * 0.015},
        [](const RumbleFrame& frame, int) {
            return dualsense_usb(frame, DualSenseRumble::from_2_24);
        },
        of_dualsense);
    check_pace(of_dualshock);
    check_pace(of_dualsense);
}

TEST_CASE("umockdev: a simple haptic device is found by its descriptor and played by its list") {
    const MockBench bench({knob()});
    SendStatistics statistics;
    {
        HidDevice device(listed("Haptic knob"));
        play_through(device, sweep());
        statistics = device.statistics();
    }
    const HapticPage page = *haptic_page(kHapticDescriptor);
    check_packets(
        bench.written("hidraw4"), 0, {sweep(), Language::intensity, 1.02 * 0.020},
        [&page](const RumbleFrame& frame, int) {
            return frame.low > 0.0 ? haptic_output(page, 4, frame.low)
                                   : haptic_output(page, kWaveformStop, 0.0);
        },
        statistics);
}

TEST_CASE("umockdev: one that is unplugged while it plays is noticed, and listed no more") {
    MockBench bench({joy_con()});
    HidDevice device(listed("Joy-Con (L)"));
    REQUIRE(device.play(sweep(), true));
    REQUIRE(comes_true([&] { return bench.written("hidraw0").size() > 5; }));
    bench.unplug("hidraw0");
    CHECK(comes_true([&] { return !device.status().playing; }));
    CHECK(device.status().trouble == "Joy-Con (L) was unplugged, or is out of reach");
    CHECK_FALSE(device.status().connected);
    CHECK_FALSE(device.play(sweep(), false));
    CHECK(hid_actuators().empty());
}

TEST_CASE("umockdev: one that is unplugged while it rests is noticed within a second") {
    MockBench bench({joy_con()});
    HidDevice device(listed("Joy-Con (L)"));
    play_through(device, sweep());
    bench.unplug("hidraw0");
    CHECK(comes_true([&] { return !device.status().connected; }));
    CHECK(device.status().trouble == "Joy-Con (L) was unplugged, or is out of reach");
}

// The sanitizer of threads hands no signal to the child of a process that has several.
#ifndef TACT_SANITIZES_THREADS
TEST_CASE(
    "umockdev: a program that is killed in the middle of a play leaves the controller neutral") {
    const MockBench bench({joy_con()});
    const Packet neutral = switch_rumble(0, {});
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        EmergencyPacket emergency_packet("/dev/hidraw0");
        emergency_packet.set(neutral);
        raise(SIGHUP);  // doctest has the signals of crashes for itself
        _exit(0);
    }
    int ended = 0;
    CHECK(waitpid(child, &ended, 0) == child);
    CHECK(WIFSIGNALED(ended));
    CHECK(WTERMSIG(ended) == SIGHUP);
    const auto written = bench.written("hidraw0");
    REQUIRE(written.size() == 2);
    CHECK(written[0].packet == neutral);
}

TEST_CASE("umockdev: a program may write on while its bench is taken down") {
    for (int round = 0; round < 30; ++round) {
        auto bench = std::make_unique<MockBench>(std::vector<MockPad>{knob()});
        const pid_t child = fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            const int pad = open("/dev/hidraw4", O_RDWR);
            const Packet report{1, 3};
            while (write(pad, report.data(), report.size()) > 0) continue;
            _exit(0);
        }
        CHECK(comes_true([&] { return bench->written("hidraw4").size() > 3; }));
        bench.reset();
        kill(child, SIGKILL);
        CHECK(waitpid(child, nullptr, 0) == child);
    }
}
#endif
