// Pads of every kind, each with its neutral packet, and what tells whether they are driven.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "devices/hid/haptic_page.h"
#include "tests/support/comes_true.h"
#include "tests/umockdev/pads.h"

namespace tact {

inline constexpr auto kInTime = std::chrono::milliseconds(100);
// A busy machine may keep any packet waiting: one good measurement is proof.
inline constexpr int kRounds = 5;

struct Kind {
    MockPad pad;
    std::string name;  // as the program lists it
    Packet neutral;
};

inline std::vector<Kind> kinds() {
    const HapticPage page = *haptic_page(kHapticDescriptor);
    MockPad dualshock_4 = dualshock();
    dualshock_4.is_bluetooth = false;
    return {{joy_con(), "Joy-Con (L)", switch_rumble(0, {})},
            {pro(), "Switch Pro Controller", switch_rumble(0, {})},
            {dualshock_4, "DualShock 4", dualshock4_usb({})},
            {dualsense(), "DualSense", dualsense_usb({}, DualSenseRumble::from_2_24)},
            {knob(), "Haptic knob", haptic_output(page, kWaveformStop, 0.0)}};
}

// Without what counts up.
inline Packet plain(Packet packet) {
    if (packet[0] == 0x10) packet[1] = 0;
    return packet;
}

inline bool is_neutral(const Kind& kind, const Packet& packet) {
    return plain(packet) == plain(kind.neutral);
}

inline bool is_driven(const MockBench& bench, const Kind& kind) {
    const auto written = bench.written(kind.pad.node);
    std::size_t driving = 0;
    for (const Written& each : written) driving += is_neutral(kind, each.packet) ? 0 : 1;
    return driving >= 8 && !is_neutral(kind, written.back().packet);
}

inline bool is_at_rest(const MockBench& bench, const Kind& kind) {
    return is_neutral(kind, bench.written(kind.pad.node).back().packet);
}

// From then on nothing but neutral packets.
inline std::chrono::steady_clock::time_point rested_at(const MockBench& bench, const Kind& kind) {
    const auto written = bench.written(kind.pad.node);
    std::size_t first = written.size();
    while (first > 0 && is_neutral(kind, written[first - 1].packet)) --first;
    return first < written.size() ? written[first].at
                                  : std::chrono::steady_clock::time_point::max();
}

// A child of this test's.
struct Process {
    pid_t pid = 0;
    std::optional<int> ended;  // as waitpid says it

    bool has_ended() {
        int how = 0;
        if (!ended && waitpid(pid, &how, WNOHANG) == pid) ended = how;
        return ended.has_value();
    }
    bool is_halted() const {
        siginfo_t about{};
        return waitid(P_PID, static_cast<id_t>(pid), &about, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
               about.si_pid == pid;
    }
};

}  // namespace tact
