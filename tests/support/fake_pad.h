// A simulated controller, for tests of what plays on it.
#pragma once

#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "devices/hid/hid_device.h"
#include "model/signal/waveform.h"

namespace tact::fake_pad {

using PadClock = std::chrono::steady_clock;

// A controller that keeps what it is sent, and answers what a real one would.
struct FakePad {
    std::mutex mutex;
    std::vector<Packet> packets;
    std::vector<PadClock::time_point> times;
    std::vector<Packet> answers;
    bool is_there = true;
    bool answers_at_all = true;
    std::chrono::milliseconds takes{0};  // to write the next packet, once
    Packet emergency_packet;

    std::vector<Packet> taken() {
        const std::lock_guard lock(mutex);
        return packets;
    }
};

inline HidPort port_of(const std::shared_ptr<FakePad>& pad) {
    HidPort port;
    port.write = [pad](std::span<const std::uint8_t> report) {
        const auto at = PadClock::now();
        std::unique_lock lock(pad->mutex);
        if (!pad->is_there) return false;
        pad->packets.emplace_back(report.begin(), report.end());
        pad->times.push_back(at);
        if (const auto takes = std::exchange(pad->takes, {}); takes.count() > 0) {
            lock.unlock();
            std::this_thread::sleep_for(takes);
            lock.lock();
        }
        if (!pad->answers_at_all) return true;
        if (report[0] == 0x80) pad->answers.push_back({0x81, report[1]});
        if (report[0] == 0x01) {
            Packet answer(49, 0);
            answer[0] = 0x21;
            answer[13] = 0x80;
            answer[14] = report[10];
            pad->answers.push_back({0x30, 0});  // an ordinary input report comes before
            pad->answers.push_back(answer);
        }
        return true;
    };
    port.read = [pad](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const std::lock_guard lock(pad->mutex);
        if (pad->answers.empty()) return Packet{};
        const Packet answer = pad->answers.front();
        pad->answers.erase(pad->answers.begin());
        return answer;
    };
    port.feature = [](int, std::size_t) { return Packet{}; };
    port.is_there = [pad] {
        const std::lock_guard lock(pad->mutex);
        return pad->is_there;
    };
    port.set_emergency_packet = [pad](std::span<const std::uint8_t> packet) {
        pad->emergency_packet.assign(packet.begin(), packet.end());
    };
    return port;
}

inline HidActuator actuator(ActuatorKind kind, HidBus bus) {
    HidActuator actuator;
    actuator.kind = kind;
    actuator.bus = bus;
    actuator.name = "the pad";
    actuator.path = "/dev/fake pad";
    actuator.vendor = 0x057e;
    return actuator;
}

inline HidDevice device_on(const std::shared_ptr<FakePad>& pad, const HidActuator& which) {
    HidPorts ports;
    ports.list = [pad, which] {
        const std::lock_guard lock(pad->mutex);
        return pad->is_there ? std::vector{which} : std::vector<HidActuator>{};
    };
    ports.may_be_opened = [pad](const HidActuator&) -> Expected<Done> {
        const std::lock_guard lock(pad->mutex);
        return pad->is_there ? Expected<Done>(Done{}) : Error{"the pad is not there"};
    };
    ports.open = [pad](const std::string&) { return port_of(pad); };
    ports.claim = [](const HidActuator&) { return ActuatorLock(); };
    return HidDevice(which, ports);
}

inline Drive tone(double duration_s) {
    Drive drive;
    drive.samples.resize(sample_count(duration_s, kModelRateHz));
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        drive.samples[n] =
            0.5 * std::sin(2.0 * std::numbers::pi * 160.0 * static_cast<double>(n) / kModelRateHz);
    }
    return drive;
}

template <class Condition>
bool soon(const Condition& condition) {
    const auto until = PadClock::now() + std::chrono::seconds(5);
    while (!condition()) {
        if (PadClock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

inline bool ended(HidDevice& device) {
    return soon([&] { return !device.status().playing; });
}

}  // namespace tact::fake_pad
