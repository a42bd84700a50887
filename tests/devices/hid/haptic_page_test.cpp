#include "devices/hid/haptic_page.h"

#include <doctest/doctest.h>

#include "model/common/random.h"
#include "tests/support/haptic_descriptor.h"

namespace haptic_page_test {

using namespace tact;

TEST_CASE("haptic page: trigger, intensity and the list of waveforms are found where they are") {
    const auto page = haptic_page(kHapticDescriptor);
    REQUIRE(page);
    CHECK(page->output_report == 2);
    CHECK(page->output_bytes == 3);
    CHECK(page->trigger.bit == 0);
    CHECK(page->trigger.bits == 4);
    CHECK(page->intensity.bit == 8);
    CHECK(page->intensity.bits == 8);
    CHECK(page->intensity.most == 200);
    CHECK(page->repeats.bit == 16);
    CHECK(page->waveform_report == 1);
    CHECK(page->waveform_bytes == 4);
    REQUIRE(page->waveforms.size() == 2);
    CHECK(page->waveforms[0].ordinal == 3);
    CHECK(page->waveforms[1].ordinal == 4);
    CHECK(page->waveforms[1].field.bit == 16);
}

TEST_CASE("haptic page: rumble is chosen before buzz, and nothing where neither goes on") {
    const HapticPage page = *haptic_page(kHapticDescriptor);
    CHECK(continuous_waveform(page, Packet{1, 0x04, 0x10, 0x05, 0x10}) == 4);
    CHECK(continuous_waveform(page, Packet{1, 0x04, 0x10, 0x03, 0x10}) == 3);
    CHECK_FALSE(continuous_waveform(page, Packet{1, 0x03, 0x10, 0x06, 0x10}));
    CHECK_FALSE(continuous_waveform(page, Packet{1, 0x03}));
    CHECK_FALSE(continuous_waveform(page, Packet{}));
}

TEST_CASE("haptic page: intensities run over the device's own range") {
    const HapticPage page = *haptic_page(kHapticDescriptor);
    CHECK(haptic_output(page, 4, 1.0) == Packet{2, 4, 200, 0});
    CHECK(haptic_output(page, 4, 0.5) == Packet{2, 4, 100, 0});
    CHECK(haptic_output(page, 4, 7.0) == Packet{2, 4, 200, 0});
    CHECK(haptic_output(page, kWaveformStop, 0.0) == Packet{2, 2, 0, 0});
}

TEST_CASE("haptic page: a game pad without one has none") {
    const Packet pad{0x05, 0x01, 0x09, 0x05, 0xA1, 0x01, 0x15, 0x00, 0x25, 0x01, 0x75,
                     0x01, 0x95, 0x08, 0x05, 0x09, 0x19, 0x01, 0x29, 0x08, 0x81, 0x02,
                     0x75, 0x08, 0x95, 0x02, 0x09, 0x01, 0x91, 0x02, 0xC0};
    CHECK_FALSE(haptic_page(pad));
    CHECK_FALSE(haptic_page({}));
}

TEST_CASE("haptic page: a descriptor cut anywhere, or with any byte changed, is read in bounds") {
    const std::span whole(kHapticDescriptor);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto page = haptic_page(whole.first(length));
        if (page) CHECK(page->trigger.bits > 0);
    }
    RandomStream random{7};
    std::size_t read = 0;
    for (int k = 0; k < 20'000; ++k) {
        Packet changed(whole.begin(), whole.end());
        for (int byte = 0; byte < 3; ++byte) {
            changed[next_index(random, changed.size())] =
                static_cast<std::uint8_t>(next_index(random, 256));
        }
        const auto page = haptic_page(changed);
        if (!page) continue;
        ++read;
        const Packet packet = haptic_output(*page, 3, 0.7);
        CHECK(packet.size() == 1 + page->output_bytes);
        continuous_waveform(*page, changed);
    }
    CHECK(read > 100);  // most changes do no harm
}

TEST_CASE("haptic page: a descriptor that floods its reader with fields is none") {
    // As many waveform fields as the kernel lets an item have, in all the items that find room, of
    // the given number of bits.
    const auto flood = [](std::uint8_t bits) {
        Packet descriptor{0x05, 0x0E, 0x09, 0x21, 0x75, 0x04, 0x95, 0x01, 0x91, 0x02,  // a trigger
                          0x09, 0x10, 0xA1, 0x02, 0x05, 0x0A, 0x75, bits, 0x96, 0x00, 0x80};
        for (int report = 1; descriptor.size() + 6 <= 4096; report = report % 255 + 1) {
            for (const int byte : {0x85, report, 0x09, 0x03, 0xB1, 0x02}) {
                descriptor.push_back(static_cast<std::uint8_t>(byte));
            }
        }
        return descriptor;
    };
    CHECK_FALSE(haptic_page(flood(1)));
    CHECK_FALSE(haptic_page(flood(32)));
    const auto nothing = haptic_page(flood(0));  // fields without bits do not count
    REQUIRE(nothing);
    CHECK(nothing->waveforms.empty());
}

}  // namespace haptic_page_test
