#include "devices/rumble/rumble_packets.h"

#include "tests/support/golden.h"

namespace rumble_packets_test {

using namespace tact;
using golden::Json;

namespace {

template <class Bytes>
std::string hex(const Bytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        constexpr const char* kDigits = "0123456789abcdef";
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

std::string text_in(const Json& golden, const char* key) {
    return golden.at(key).get<std::string>();
}

RumbleFrame frame_of(const Json& numbers) {
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace

TEST_CASE("rumble: an actuator's four bytes are those of an independent encoder") {
    for (const Json& golden : golden::read("rumble.json", "hd_rumble")) {
        CAPTURE(golden.at("frame").dump());
        CHECK(hex(hd_rumble(frame_of(golden.at("frame")))) == text_in(golden, "bytes"));
    }
}

TEST_CASE("rumble: amplitudes become the nearest index of the table, and never one above 100") {
    for (const Json& golden : golden::read("rumble.json", "amplitudes")) {
        CAPTURE(golden.at("share").dump());
        const int index = amplitude_index(golden.at("share"));
        CHECK(index == golden.at("index"));
        CHECK(std::abs(amplitude_of_index(index) - golden.at("amplitude").get<double>()) <= 1e-12);
    }
    CHECK(amplitude_index(1e9) == 100);
    CHECK(amplitude_index(std::nan("")) == 0);
}

TEST_CASE("rumble: whatever is asked for, no byte goes beyond what the actuator stands") {
    for (double low = 0.0; low < 3.0; low += 0.07) {
        for (double high = 0.0; high < 3.0; high += 0.07) {
            const auto bytes = hd_rumble(within_one_coil({60.0, low, 700.0, high}));
            CHECK((bytes[1] >> 1) <= kSafestAmplitudeIndex);
            CHECK(bytes[3] <= 0x72);
            const RumbleFrame sent = hd_rumble_in(bytes);
            CHECK(sent.low + sent.high <= std::exp2(1.0 / 32.0));  // rounded up by half a step
        }
    }
}

TEST_CASE("rumble: what is read back is within half a step of what was asked for") {
    const double half_step = std::exp2(1.0 / 64.0);
    for (double f_hz = 82.0; f_hz < 620.0; f_hz *= 1.013) {
        const RumbleFrame asked{f_hz, 0.4, 2.0 * f_hz, 0.3};
        const RumbleFrame got = hd_rumble_in(hd_rumble(asked));
        CHECK(std::max(got.low_hz / f_hz, f_hz / got.low_hz) <= half_step * 1.0001);
        CHECK(std::max(got.high_hz / asked.high_hz, asked.high_hz / got.high_hz) <=
              half_step * 1.0001);
        CHECK(std::max(got.low / 0.4, 0.4 / got.low) <= half_step * 1.0001);
        CHECK(std::max(got.high / 0.3, 0.3 / got.high) <= half_step * 1.0001);
    }
}

TEST_CASE("rumble: silence is the neutral packet, with the counter's lowest four bits") {
    CHECK(hex(switch_rumble(19, {})) == "10030001404000014040");
    CHECK(hex(switch_rumble(0, {77.0, 0.0, 99.0, 0.0})) == "10000001404000014040");
}

TEST_CASE("rumble: a subcommand carries the running vibration along") {
    const RumbleFrame frame{160.0, 0.5, 320.0, 0.0};
    const Packet packet = switch_subcommand(2, frame, kEnableVibration, 1);
    CHECK(packet.size() == 49);
    CHECK(hex(std::span(packet).first(12)) == "010200014062000140624801");
    CHECK(std::ranges::count(std::span(packet).subspan(12), 0) == 37);
}

TEST_CASE("rumble: an acknowledgement is of one subcommand, and only where its bit is set") {
    Packet report(49, 0);
    report[0] = 0x21;
    report[13] = 0x80;
    report[14] = kEnableVibration;
    CHECK(acknowledges(report, kEnableVibration));
    CHECK_FALSE(acknowledges(report, 0x03));
    report[13] = 0x00;
    CHECK_FALSE(acknowledges(report, kEnableVibration));
    CHECK_FALSE(acknowledges(std::span(report).first(14), kEnableVibration));
}

TEST_CASE("rumble: a pad on a cable is woken by 80 02, 80 03, 80 02, 80 04") {
    std::string sent;
    for (const std::uint8_t command : kSwitchUsbCommands) sent += hex(switch_usb(command));
    CHECK(sent == "8002800380028004");
}

TEST_CASE("rumble: Sony's reports and their checksums are those of an independent encoder") {
    using enum DualSenseRumble;
    for (const Json& golden : golden::read("rumble.json", "sony")) {
        CAPTURE(golden.dump());
        RumbleFrame frame;
        frame.low = golden.at("low");
        frame.high = golden.at("high");
        CHECK(hex(dualshock4_usb(frame)) == text_in(golden, "dualshock4_usb"));
        CHECK(hex(dualshock4_bluetooth(frame)) == text_in(golden, "dualshock4_bluetooth"));
        CHECK(hex(dualsense_usb(frame, before_2_24)) == text_in(golden, "dualsense_usb"));
        CHECK(hex(dualsense_bluetooth(golden.at("counter"), frame, before_2_24)) ==
              text_in(golden, "dualsense_bluetooth"));
        CHECK(hex(dualsense_usb(frame, from_2_24)) == text_in(golden, "dualsense_usb_from_2_24"));
        CHECK(hex(dualsense_bluetooth(golden.at("counter_from_2_24"), frame, from_2_24)) ==
              text_in(golden, "dualsense_bluetooth_from_2_24"));
    }
}

}  // namespace rumble_packets_test
