#include <cstdint>
#include <cstring>

#include "devices/hid/haptic_page.h"
#include "devices/rumble/rumble_packets.h"
#include "tests/fuzz/readers.h"

namespace tact::fuzz {
namespace {

std::vector<std::uint8_t> packet_of(std::string_view bytes) {
    std::vector<std::uint8_t> packet(bytes.size());
    if (!bytes.empty()) std::memcpy(packet.data(), bytes.data(), bytes.size());
    return packet;
}

// The first byte: how many of the others are the descriptor; the rest is its waveform report.
bool descriptor(std::string_view bytes) {
    const auto all = packet_of(bytes);
    const std::span<const std::uint8_t> span = all;
    const std::size_t split =
        span.empty() ? 0 : std::min<std::size_t>(span.size(), 1 + std::size_t{4} * span[0]);
    const auto page = haptic_page(span.subspan(0, split));
    const auto whole = haptic_page(span);
    if (page) continuous_waveform(*page, span.subspan(split));
    if (whole) continuous_waveform(*whole, span);
    return page || whole;
}

std::vector<std::string> descriptor_seeds() {
    const auto bytes = [](std::initializer_list<int> values) {
        std::string text;
        for (const int value : values) text += static_cast<char>(value);
        return text;
    };
    // Usage page "haptics" (0x0e), a controller, its waveform list and a manual trigger.
    return {bytes({0x05, 0x0e, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x01, 0x09, 0x10, 0xa1,
                   0x02, 0x05, 0x0a, 0x09, 0x03, 0x15, 0x00, 0x26, 0xff, 0x7f, 0x75,
                   0x10, 0x95, 0x01, 0xb1, 0x02, 0xc0, 0x05, 0x0e, 0x09, 0x21, 0x75,
                   0x08, 0x95, 0x01, 0x91, 0x02, 0x09, 0x23, 0x91, 0x02, 0xc0})};
}

bool acknowledgement(std::string_view bytes) {
    const auto packet = packet_of(bytes);
    bool any = false;
    for (int subcommand = 0; subcommand < 256; ++subcommand)
        any |= acknowledges(packet, subcommand);
    return any;
}

std::vector<std::string> acknowledgement_seeds() {
    return {std::string("\x21\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x80\x48", 15)};
}

}  // namespace

std::span<const Reader> device_readers() {
    static const std::vector<Reader> all{
        {"descriptor", descriptor, descriptor_seeds, {}},
        {"acknowledgement", acknowledgement, acknowledgement_seeds, {}}};
    return all;
}

}  // namespace tact::fuzz
