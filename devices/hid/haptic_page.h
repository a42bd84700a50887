// Simple haptic controllers: devices that say in their report descriptor how they are asked to
// vibrate, by the haptics page (0x0E) of USB HID.
//
// They offer numbered waveforms and an intensity, but no frequency: only an envelope gets through.
//
// Source    USB-IF HID Usage Tables 1.4, chapter 23; Device Class Definition for HID 1.11, 6.2.2.
// Input     the report descriptor, as Linux has it in report_descriptor beside a hidraw node
// Left out  auto triggers, several actuators, waveforms that end by themselves (clicks).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "devices/rumble/rumble_packets.h"

namespace tact {

// A number within a report, its bits counted from behind the report's own number.
struct ReportField {
    std::size_t bit = 0;
    std::size_t bits = 0;  // 0: the report has no such field
    std::int32_t least = 0;
    std::int32_t most = 0;
};

// Where one of the numbered waveforms says what it is: fields of a feature report.
struct WaveformOrdinal {
    int ordinal = 0;
    ReportField field;
};

// What a descriptor says about its haptics.
struct HapticPage {
    std::uint8_t output_report = 0;  // 0: reports have no numbers
    std::size_t output_bytes = 0;    // without the number
    ReportField trigger;             // which ordinal to play
    ReportField intensity;
    ReportField repeats;
    ReportField retrigger_period;
    ReportField cutoff_time;
    std::uint8_t waveform_report = 0;
    std::size_t waveform_bytes = 0;
    std::vector<WaveformOrdinal> waveforms;
};

// Nothing where there is no haptics page with a manual trigger, or the descriptor is broken.
std::optional<HapticPage> haptic_page(std::span<const std::uint8_t> descriptor);

inline constexpr int kWaveformNone = 1;  // the two ordinals that no list names
inline constexpr int kWaveformStop = 2;

// The ordinal of a waveform that continues until stopped, rumble before buzz, from an answer to the
// waveform report, its number first. Nothing if the device has no such waveform.
std::optional<int> continuous_waveform(const HapticPage& page,
                                       std::span<const std::uint8_t> waveform_report);

// Plays an ordinal at a share of the full intensity.
Packet haptic_output(const HapticPage& page, int ordinal, double share);

}  // namespace tact
