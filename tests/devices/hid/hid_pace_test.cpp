// When packets go out, and how strong they are, as a controller sees it. Gaps are only ever held
// against what is least: how much longer they are is the machine's doing.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/fake_pad.h"

namespace hid_pace_test {

using namespace tact;
using namespace tact::fake_pad;

namespace {

// Louder from sample to sample: no two frames alike, so that each is sent.
Drive rising(double duration_s) {
    Drive drive = tone(duration_s);
    const auto length = static_cast<double>(drive.samples.size());
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        drive.samples[n] *= 0.1 + 1.8 * static_cast<double>(n) / length;
    }
    return drive;
}

// Packets that rumble: those that wake a controller go by its answers.
struct Sent {
    std::vector<Packet> packets;
    std::vector<PadClock::time_point> times;
};

Sent sent_to(FakePad& pad) {
    const std::lock_guard lock(pad.mutex);
    Sent sent;
    for (std::size_t k = 0; k < pad.packets.size(); ++k) {
        if (pad.packets[k][0] == 0x80 || pad.packets[k][0] == 0x01) continue;
        sent.packets.push_back(pad.packets[k]);
        sent.times.push_back(pad.times[k]);
    }
    return sent;
}

double least_gap_s(const std::vector<PadClock::time_point>& times) {
    REQUIRE(times.size() > 2);
    double least_s = 1e9;
    for (std::size_t k = 1; k < times.size(); ++k) {
        least_s = std::min(least_s, std::chrono::duration<double>(times[k] - times[k - 1]).count());
    }
    return least_s;
}

bool has_sent(FakePad& pad, std::size_t packets) {
    return soon([&] { return sent_to(pad).packets.size() >= packets; });
}

// DualShock 4 on its cable.
double weak_motor(const Packet& packet) { return packet[4] / 255.0; }

}  // namespace

TEST_CASE("hid: a controller's least gap is what its bus and its firmware stand") {
    const auto period_s = [](ActuatorKind kind, HidBus bus) {
        return packet_period_s(actuator(kind, bus));
    };
    CHECK(period_s(ActuatorKind::joy_con, HidBus::bluetooth) == 0.030);
    CHECK(period_s(ActuatorKind::switch_pro, HidBus::bluetooth) == 0.030);
    CHECK(period_s(ActuatorKind::switch_pro, HidBus::usb) == 0.015);
    CHECK(period_s(ActuatorKind::joy_con, HidBus::usb) == 0.015);  // in its grip
    CHECK(period_s(ActuatorKind::dualshock_4, HidBus::bluetooth) == 0.020);
    CHECK(period_s(ActuatorKind::dualshock_4, HidBus::usb) == 0.015);
    CHECK(period_s(ActuatorKind::dualsense, HidBus::usb) == 0.015);
    CHECK(period_s(ActuatorKind::simple_haptic, HidBus::usb) == 0.020);
}

TEST_CASE("hid: no two packets are closer than the bus stands, over all seams of short loops" *
          doctest::test_suite("long")) {
    for (const HidBus bus : {HidBus::bluetooth, HidBus::usb}) {
        for (const double duration_s : {0.1, 0.035, 0.016, 0.001}) {
            CAPTURE(duration_s);
            const auto pad = std::make_shared<FakePad>();
            const HidActuator which = actuator(ActuatorKind::switch_pro, bus);
            {
                HidDevice device = device_on(pad, which);
                REQUIRE(device.play(rising(duration_s), true));
                REQUIRE(has_sent(*pad, 12));
            }
            CHECK(least_gap_s(sent_to(*pad).times) >= packet_period_s(which));
        }
    }
}

TEST_CASE("hid: plays in quick succession, and what silences them, keep the gap as well" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    const HidActuator which = actuator(ActuatorKind::joy_con, HidBus::bluetooth);
    {
        HidDevice device = device_on(pad, which);
        for (std::size_t k = 0; k < 12; ++k) {
            REQUIRE(device.play(rising(0.3), false));
            REQUIRE(has_sent(*pad, 3 * k + 1));
            if (k % 3 == 1) device.stop();
        }
    }
    CHECK(least_gap_s(sent_to(*pad).times) >= packet_period_s(which));
}

TEST_CASE("hid: every part of a short loop is played in its turn, in whatever step with the pace" *
          doctest::test_suite("long")) {
    // 35 ms: loud for 30 and faint for 5, of which packets every 30 ms meet now one, now the other.
    const auto pad = std::make_shared<FakePad>();
    {
        HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
        REQUIRE(device.play(rising(0.035), true));
        REQUIRE(has_sent(*pad, 40));
    }
    const Sent sent = sent_to(*pad);
    const auto first = std::ranges::count_if(sent.packets, [&](const Packet& packet) {
        return std::equal(packet.begin() + 2, packet.end(), sent.packets[0].begin() + 2);
    });
    CHECK(first > 8);  // its share of 40 is most of them, whatever the machine makes late
}

TEST_CASE("hid: frames that a slow write has passed by are skipped, not queued" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::joy_con, HidBus::bluetooth));
    REQUIRE(device.play(rising(10.0), false));
    REQUIRE(has_sent(*pad, 2));
    {
        const std::lock_guard lock(pad->mutex);
        pad->takes = std::chrono::milliseconds(600);
    }
    // 600 ms are 19 frames, of which one is of that moment.
    CHECK(soon([&] { return device.statistics().skipped >= 17; }));
    device.stop();
    CHECK(ended(device));
    CHECK(least_gap_s(sent_to(*pad).times) >= 0.030);
}

TEST_CASE("hid: a motor moves at a tenth of the level, and patterns keep their proportions" *
          doctest::test_suite("long")) {
    // Strength of a steady tone of the weak motor's band.
    const auto strength = [](double level, double amplitude) {
        const auto pad = std::make_shared<FakePad>();
        HidDevice device = device_on(pad, actuator(ActuatorKind::dualshock_4, HidBus::usb));
        device.set_level(level);
        Drive drive = tone(0.6);
        for (double& sample : drive.samples) sample *= 2.0 * amplitude;
        REQUIRE(device.play(drive, false));
        CHECK(ended(device));
        // The steady duty is the one that is repeated: the others bring the motor there.
        const Sent sent = sent_to(*pad);
        std::vector<double> duties;
        for (const Packet& packet : sent.packets) duties.push_back(weak_motor(packet));
        std::ranges::sort(duties);
        double steady = 0.0;
        std::ptrdiff_t most = 0;
        for (const double one : duties) {
            if (one == 0.0 || one == 1.0) continue;
            const auto times = std::ranges::count(duties, one);
            if (times > most) steady = one;
            most = std::max(most, times);
        }
        const double speed = speed_after(kWeakMotor, 0.0, steady, 10.0);
        return speed * speed;
    };
    const double full = strength(1.0, 0.9) / 0.9;
    CHECK(full > 0.7);  // the split leaves four fifths of 160 Hz
    for (const double level : {0.1, 0.3, 1.0}) {
        for (const double amplitude : {0.3, 0.9}) {
            CAPTURE(level);
            CAPTURE(amplitude);
            const double meant = level * amplitude * full;
            // Half a step of the duty is 1/434 of the speed, whose square is the strength.
            CHECK(std::abs(std::sqrt(strength(level, amplitude)) - std::sqrt(meant)) <= 0.006);
        }
    }
}

namespace {

// Onsets of three plays in turn, the second and the third asked for as a program does: when the end
// of the one before them is told, at the latest.
std::vector<PadClock::time_point> onsets_in_turn(double duration_s, double rest_s) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::dualshock_4, HidBus::usb));
    REQUIRE(device.play(tone(duration_s), false));
    REQUIRE(device.play_after(tone(duration_s), rest_s));
    REQUIRE(ended(device));  // told by one status
    REQUIRE(device.play_after(tone(duration_s), rest_s));
    CHECK(device.status().playing);
    REQUIRE(ended(device));
    REQUIRE(ended(device));
    const Sent sent = sent_to(*pad);
    std::vector<PadClock::time_point> onsets;
    bool was_still = true;
    for (std::size_t k = 0; k < sent.packets.size(); ++k) {
        const bool is_still = sent.packets[k][4] == 0 && sent.packets[k][5] == 0;
        if (was_still && !is_still) onsets.push_back(sent.times[k]);
        was_still = is_still;
    }
    return onsets;
}

}  // namespace

TEST_CASE("hid: plays in turn keep their pauses to 1 ms, whenever the next one is asked for" *
          doctest::test_suite("long")) {
    // The thread may be woken late: one good measurement is proof.
    for (const double rest_s : {0.08, 0.3}) {
        CAPTURE(rest_s);
        CHECK(soon([&] {
            const auto onsets = onsets_in_turn(0.2, rest_s);
            REQUIRE(onsets.size() == 3);
            double worst_s = 0.0;
            for (std::size_t k = 1; k < 3; ++k) {
                const double since_s =
                    std::chrono::duration<double>(onsets[k] - onsets[k - 1]).count();
                worst_s = std::max(worst_s, std::abs(since_s - 0.2 - rest_s));
            }
            return worst_s <= 0.001;
        }));
    }
}

TEST_CASE("hid: a stop takes along what waits, and what comes after it is played" *
          doctest::test_suite("long")) {
    const auto pad = std::make_shared<FakePad>();
    HidDevice device = device_on(pad, actuator(ActuatorKind::dualshock_4, HidBus::usb));
    REQUIRE(device.play(tone(5.0), false));
    REQUIRE(device.play_after(tone(5.0), 0.1));
    REQUIRE(has_sent(*pad, 3));
    device.stop();
    REQUIRE(ended(device));
    const std::size_t sent = sent_to(*pad).packets.size();
    REQUIRE(device.play_after(tone(0.1), 0.05));
    CHECK(device.status().playing);
    REQUIRE(ended(device));
    CHECK(sent_to(*pad).packets.size() > sent);
}

}  // namespace hid_pace_test
