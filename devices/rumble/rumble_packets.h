// What is written to game controllers so that they vibrate: bytes, and nothing else.
//
// Nintendo's HD rumble (Joy-Con, Switch Pro) names two frequencies with an amplitude each; Sony's
// pads have two motors with off-centre masses, whose frequency follows their strength.
//
// Source    dekuNukem's Joy-Con notes, SDL's and the kernel's drivers, MissionControl's decoder
//           (HD rumble); SDL and hid-playstation (DualShock 4, DualSense).
// Output    whole reports as hid_write takes them, the report's number first
// Left out  Switch 2 controllers, several samples a packet, adaptive triggers, lights.
// Exact     the same frame gives the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tact {

using Packet = std::vector<std::uint8_t>;

// What an actuator does until the next frame. Amplitudes are shares of the strongest that is safe
// to ask for, 0..1. Motors have no frequency to choose: low is the strong one, high the weak one.
struct RumbleFrame {
    double low_hz = 160.0;
    double low = 0.0;
    double high_hz = 320.0;
    double high = 0.0;

    bool operator==(const RumbleFrame&) const = default;
};

// ---------------------------------------------------------------- Nintendo's HD rumble

// What the two bands can be asked for; the steps between are 2^(1/32), 2.2 %.
inline constexpr double kLowestLowBandHz = 40.88;
inline constexpr double kHighestLowBandHz = 626.29;
inline constexpr double kLowestHighBandHz = 81.75;
inline constexpr double kHighestHighBandHz = 1252.57;

// Indices above 100 of the amplitude table are known to wear the resonant actuator out.
inline constexpr int kSafestAmplitudeIndex = 100;

// The nearest index of the table, at most kSafestAmplitudeIndex, and what an index stands for.
int amplitude_index(double share);
double amplitude_of_index(int index);

// Both bands drive one coil: scaled down together where their sum is above 1.
RumbleFrame within_one_coil(RumbleFrame frame);

// One actuator's frame. Frequencies are moved into their band.
std::array<std::uint8_t, 4> hd_rumble(const RumbleFrame& frame);

// What four such bytes ask for: the frame as it is after rounding.
RumbleFrame hd_rumble_in(std::span<const std::uint8_t, 4> bytes);

// Both sides alike; a Joy-Con takes its own. `counter` goes up by one a packet, of either kind.
Packet switch_rumble(int counter, const RumbleFrame& frame);
Packet switch_subcommand(int counter, const RumbleFrame& frame, int subcommand, int argument);

inline constexpr int kEnableVibration = 0x48;  // a subcommand; argument 1 or 0

// Whether an input report says that a subcommand was carried out.
bool acknowledges(std::span<const std::uint8_t> report, int subcommand);

// A pad on a USB cable wants these in turn before it listens; hid-nintendo sends them itself.
inline constexpr std::array<std::uint8_t, 4> kSwitchUsbCommands{0x02, 0x03, 0x02, 0x04};
Packet switch_usb(int command);

// ---------------------------------------------------------------- Sony's pads

Packet dualshock4_usb(const RumbleFrame& frame);
Packet dualshock4_bluetooth(const RumbleFrame& frame);

// Which switch of a DualSense turns its imitation of motors on, by its firmware.
enum class DualSenseRumble { before_2_24, from_2_24 };

Packet dualsense_usb(const RumbleFrame& frame, DualSenseRumble firmware);
// `counter` 0..15, one more a packet.
Packet dualsense_bluetooth(int counter, const RumbleFrame& frame, DualSenseRumble firmware);

}  // namespace tact
