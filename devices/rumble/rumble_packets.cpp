#include "devices/rumble/rumble_packets.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tact {

namespace {

// E(f) = 32 log2(f / 10), clamped to what a band has codes for.
int frequency_code(double frequency_hz, int lowest, int highest) {
    const double code = std::round(32.0 * std::log2(std::max(frequency_hz, 10.0) / 10.0));
    return static_cast<int>(std::clamp(code, double(lowest), double(highest)));
}

double frequency_of_code(int code) { return 10.0 * std::exp2(code / 32.0); }

constexpr int kLowBandOffset = 0x40;
constexpr int kHighBandOffset = 0x60;
constexpr int kBandCodes = 0x7F;  // 1 .. 0x7F above the offset

std::uint8_t byte(int value) { return static_cast<std::uint8_t>(value & 0xFF); }

// 0 for silence, 255 for all of it; never 0 for what is not silent.
std::uint8_t motor_byte(double share) {
    if (!(share > 0.0)) return 0;
    return byte(std::clamp(static_cast<int>(std::lround(share * 255.0)), 1, 255));
}

// CRC-32 as in zlib, over the kind of transaction (output: A2) and the report.
std::uint32_t bluetooth_checksum(std::span<const std::uint8_t> report) {
    std::uint32_t crc = 0xFFFFFFFFU;
    const auto add = [&crc](std::uint8_t next) {
        crc ^= next;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    };
    add(0xA2);
    for (const std::uint8_t next : report) add(next);
    return ~crc;
}

// Fills the last four bytes, lowest first.
void sign(Packet& packet) {
    const std::size_t at = packet.size() - 4;
    const std::uint32_t crc = bluetooth_checksum(std::span(packet).first(at));
    for (std::size_t k = 0; k < 4; ++k) packet[at + k] = byte(static_cast<int>(crc >> (8 * k)));
}

void put_both_sides(Packet& packet, const RumbleFrame& frame) {
    const auto bytes = hd_rumble(within_one_coil(frame));
    std::ranges::copy(bytes, packet.begin() + 2);
    std::ranges::copy(bytes, packet.begin() + 6);
}

// The block that both transports share, from its first byte on.
void put_dualsense_block(std::span<std::uint8_t> block, const RumbleFrame& frame,
                         DualSenseRumble firmware) {
    constexpr std::uint8_t kMotorsImitated = 0x01;
    constexpr std::uint8_t kNoSoundToActuators = 0x02;
    constexpr std::uint8_t kMotorsImitatedNewly = 0x04;
    const bool is_new = firmware == DualSenseRumble::from_2_24;
    block[0] = is_new ? kNoSoundToActuators : kMotorsImitated | kNoSoundToActuators;
    block[2] = motor_byte(frame.high);
    block[3] = motor_byte(frame.low);
    if (is_new) block[38] = kMotorsImitatedNewly;
}

}  // namespace

int amplitude_index(double share) {
    if (!(share > 0.0)) return 0;
    double index = 32.0 * std::log2(8.7 * share);
    if (share < 0.2274) index = 16.0 * std::log2(17.0 * share);
    if (share < 0.115) index = 4.0 * std::log2(119.6 * share);
    return static_cast<int>(std::clamp(std::round(index), 0.0, double(kSafestAmplitudeIndex)));
}

double amplitude_of_index(int index) {
    if (index <= 0) return 0.0;
    if (index < 16) return std::exp2(index / 4.0) / 119.6;
    if (index < 32) return std::exp2(index / 16.0) / 17.0;
    return std::exp2(index / 32.0) / 8.7;
}

RumbleFrame within_one_coil(RumbleFrame frame) {
    const double sum = frame.low + frame.high;
    if (!(sum > 1.0)) return frame;
    frame.low /= sum;
    frame.high /= sum;
    return frame;
}

std::array<std::uint8_t, 4> hd_rumble(const RumbleFrame& frame) {
    const int low_amplitude = amplitude_index(frame.low);
    const int high_amplitude = amplitude_index(frame.high);
    // A silent band stays at its rest, so that silence is always the same bytes.
    const double low_hz = low_amplitude > 0 ? frame.low_hz : RumbleFrame{}.low_hz;
    const double high_hz = high_amplitude > 0 ? frame.high_hz : RumbleFrame{}.high_hz;
    const int low =
        frequency_code(low_hz, kLowBandOffset + 1, kLowBandOffset + kBandCodes) - kLowBandOffset;
    const int high =
        4 * (frequency_code(high_hz, kHighBandOffset + 1, kHighBandOffset + kBandCodes) -
             kHighBandOffset);
    return {byte(high), byte((high_amplitude << 1) | (high >> 8)),
            byte(low | ((low_amplitude & 1) << 7)), byte(0x40 + (low_amplitude >> 1))};
}

RumbleFrame hd_rumble_in(std::span<const std::uint8_t, 4> bytes) {
    const int high = (bytes[0] | ((bytes[1] & 1) << 8)) / 4;
    const int low = bytes[2] & 0x7F;
    RumbleFrame frame;
    frame.high_hz = frequency_of_code(high + kHighBandOffset);
    frame.high = amplitude_of_index(bytes[1] >> 1);
    frame.low_hz = frequency_of_code(low + kLowBandOffset);
    frame.low = amplitude_of_index(((bytes[3] & 0x3F) << 1) | (bytes[2] >> 7));
    return frame;
}

Packet switch_rumble(int counter, const RumbleFrame& frame) {
    Packet packet(10, 0);
    packet[0] = 0x10;
    packet[1] = byte(counter & 0xF);
    put_both_sides(packet, frame);
    return packet;
}

// The subcommand carries rumble, too: neutral bytes would cut a running vibration.
Packet switch_subcommand(int counter, const RumbleFrame& frame, int subcommand, int argument) {
    Packet packet(49, 0);
    packet[0] = 0x01;
    packet[1] = byte(counter & 0xF);
    put_both_sides(packet, frame);
    packet[10] = byte(subcommand);
    packet[11] = byte(argument);
    return packet;
}

bool acknowledges(std::span<const std::uint8_t> report, int subcommand) {
    return report.size() > 14 && report[0] == 0x21 && (report[13] & 0x80) != 0 &&
           report[14] == subcommand;
}

Packet switch_usb(int command) { return {0x80, byte(command)}; }

Packet dualshock4_usb(const RumbleFrame& frame) {
    Packet packet(32, 0);
    packet[0] = 0x05;
    packet[1] = 0x01;  // the motors alone: lights stay as they are
    packet[4] = motor_byte(frame.high);
    packet[5] = motor_byte(frame.low);
    return packet;
}

Packet dualshock4_bluetooth(const RumbleFrame& frame) {
    Packet packet(78, 0);
    packet[0] = 0x11;
    packet[1] = 0xC0;  // with a checksum, at its own pace
    packet[3] = 0x01;
    packet[6] = motor_byte(frame.high);
    packet[7] = motor_byte(frame.low);
    sign(packet);
    return packet;
}

Packet dualsense_usb(const RumbleFrame& frame, DualSenseRumble firmware) {
    Packet packet(48, 0);
    packet[0] = 0x02;
    put_dualsense_block(std::span(packet).subspan(1), frame, firmware);
    return packet;
}

Packet dualsense_bluetooth(int counter, const RumbleFrame& frame, DualSenseRumble firmware) {
    Packet packet(78, 0);
    packet[0] = 0x31;
    packet[1] = byte((counter & 0xF) << 4);
    packet[2] = 0x10;
    put_dualsense_block(std::span(packet).subspan(3), frame, firmware);
    sign(packet);
    return packet;
}

}  // namespace tact
