// tactspace play: patterns on an actuator, one or all of them.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "devices/calibration/calibration_file.h"
#include "devices/device/drive.h"
#include "devices/device/ledger.h"
#include "devices/device/protection.h"
#include "devices/device_list.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(5);

struct ChosenDevice {
    DeviceInfo info;
    DeviceChoice choice;
};

// What is left are different outputs.
void drop_second_names(std::vector<DeviceInfo>& devices) {
    std::vector<DeviceInfo> kept;
    for (const DeviceInfo& device : devices) {
        const auto is_same = [&](const DeviceInfo& other) {
            return place_of_sound(other) == place_of_sound(device);
        };
        if (std::ranges::none_of(kept, is_same)) kept.push_back(device);
    }
    devices = std::move(kept);
}

// The device that was asked for; without a word, the only one there is.
Expected<ChosenDevice> chosen_device(const PlayCommand& command, AudioHost& host) {
    std::vector<DeviceInfo> devices = list_devices(host);
    if (command.device.empty()) drop_second_names(devices);
    // No device is better than another: the empty name is part of every one.
    const Expected<DeviceInfo> device = find_device(devices, command.device);
    if (const std::string fault = cards_fault(host); !fault.empty()) {
        std::cerr << "tactspace: " << fault << "\n";
    }
    if (!device && command.device.empty() && devices.size() > 1) {
        std::string names;
        for (const DeviceInfo& each : devices) names += "\n  --device \"" + each.id + "\"";
        return Error{"there are several devices; choose one with" + names};
    }
    if (!device) return device.error();
    ChosenDevice chosen{*device, {}};
    chosen.choice.id = device->id;
    chosen.choice.of_channels = command.of_channels;
    chosen.choice.buffer_s = 1e-3 * command.buffer_ms;
    if (command.channel.empty()) return chosen;
    const Expected<int> channel = find_channel(*device, command.channel);
    if (!channel) return channel.error();
    chosen.choice.channel = *channel;
    return chosen;
}

Expected<std::vector<std::size_t>> asked_patterns(const PlayCommand& command,
                                                  const PatternSet& set) {
    std::vector<std::size_t> places;
    if (command.all == !command.pattern.empty()) {
        return Error{"expected --pattern NAME or --all, one of the two"};
    }
    for (std::size_t k = 0; command.all && k < set.vibrations.size(); ++k) places.push_back(k);
    if (command.all) return places;
    const Expected<std::size_t> place = place_of(set, command.pattern);
    if (!place) return place.error();
    return std::vector<std::size_t>{*place};
}

struct Prepared {
    std::string name;
    Drive drive;
};

// Until it has been felt to its end.
Expected<DeviceStatus> felt(Device& device, std::stop_token stop) {
    for (;;) {
        const DeviceStatus status = device.status();
        if (!status.trouble.empty()) return Error{status.trouble};
        if (!status.playing || stop.stop_requested()) return status;
        std::this_thread::sleep_for(kPoll);
    }
}

// False: stopped in the meantime.
bool waited(double seconds, std::stop_token stop) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < until) {
        if (stop.stop_requested()) return false;
        std::this_thread::sleep_for(kPoll);
    }
    return true;
}

void say(const std::string& name, const DeviceStatus& status) {
    const std::string held = words_on_held(status.kept, status.is_warm);
    if (!held.empty()) std::cerr << "tactspace: \"" << name << "\" " << held << "\n";
    if (status.clipped && status.kept >= 1.0) {
        std::cerr << "tactspace: \"" << name
                  << "\" was too strong at this level and turned down; a larger --full-scale or a "
                     "smaller --level keeps its strength\n";
    }
    if (status.dropouts > 0) {
        std::cerr << "tactspace: \"" << name
                  << "\" had gaps: the computer was too slow to play it whole; a larger --buffer "
                     "may help\n";
    }
}

void remark(const std::string& name, const std::string& text) {
    if (!text.empty()) std::cerr << "tactspace: \"" << name << "\" " << text << "\n";
}

// What the calibration makes of it; or full scale taken for a number of g, and the actuator
// protected.
Prepared prepared(const Vibration& vibration, const std::optional<Calibration>& calibration,
                  const PlayCommand& command) {
    const Waveform waveform = waveform_of(vibration);
    if (!calibration) {
        ProtectedDrive made =
            protected_drive(drive_of(waveform, command.full_scale_g), command.loop,
                            !command.no_protection, command.longest_s);
        remark(vibration.name, made.remark);
        return {vibration.name, std::move(made.drive)};
    }
    CalibratedDrive driven =
        calibrated_drive(waveform, *calibration, command.loop, command.longest_s);
    for (const std::string& warning : driven.warnings) remark(vibration.name, warning);
    return {vibration.name, std::move(driven.drive)};
}

void announce(const PlayCommand& command, const ChosenDevice& chosen, bool is_calibrated) {
    const DeviceInfo& device = chosen.info;
    std::cerr << "tactspace: playing on " << device.name;
    if (!device.server_output.empty()) std::cerr << " (" << device.server_output << ")";
    if (!device.channels.empty())
        std::cerr << ", channel " << channel_text(chosen.info, chosen.choice.channel);
    if (is_calibrated) {
        std::cerr << ", calibrated by " << command.calibration.string() << "\n";
    } else {
        std::cerr << ", uncalibrated: full scale stands for " << command.full_scale_g << " g\n";
    }
}

nlohmann::json report_of(const Prepared& pattern, const DeviceStatus& status) {
    return {
        {"pattern", pattern.name},
        {"duration_s", static_cast<double>(pattern.drive.samples.size()) / pattern.drive.rate_hz},
        {"clipped", status.clipped},
        {"kept", status.kept},
        {"ended_warm", status.is_warm},
        {"dropouts", status.dropouts}};
}

// One after the other. The device keeps the time between them to the sample: it has to have the
// next one before the end of the one that plays.
Expected<nlohmann::json> play_in_turn(Device& device, std::size_t count,
                                      const std::function<Prepared(std::size_t)>& prepare,
                                      const PlayCommand& command, std::stop_token stop) {
    nlohmann::json reports = nlohmann::json::array();
    const std::stop_callback silence(stop, [&device] { device.stop(); });
    bool waits = false;  // on the device already
    Prepared next = prepare(0);
    const double longest_s = next.drive.longest_s;
    for (std::size_t k = 0; k < count; ++k) {
        const Prepared pattern = std::exchange(next, {});
        if (count > 1) std::cerr << "tactspace: " << pattern.name << "\n";
        if (!waits) {
            const auto begun = device.play(pattern.drive, command.loop);
            if (!begun) return begun.error();
        }
        const bool is_last = k + 1 == count;
        if (!is_last) next = prepare(k + 1);
        waits = !is_last && !command.loop;
        if (const auto asked = waits ? device.play_after(next.drive, command.gap_s) : Done{};
            !asked)
            return asked.error();
        const auto status = felt(device, stop);
        if (!status) return status.error();
        say(pattern.name, *status);
        if (stop.stop_requested()) return Error{"stopped"};
        reports.push_back(report_of(pattern, *status));
        if (!is_last && !waits && !waited(command.gap_s, stop)) return Error{"stopped"};
    }
    if (command.loop && std::isfinite(longest_s)) {
        std::cerr << "tactspace: stopped after " << longest_s << " s; --longest says how long\n";
    }
    return reports;
}

}  // namespace

Expected<Done> run(const PlayCommand& command) {
    const Interrupt interrupt;  // first: threads inherit what it blocks
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    const Expected<std::vector<std::size_t>> places = asked_patterns(command, *set);
    if (!places) return places.error();
    std::optional<Calibration> calibration;
    if (!command.calibration.empty()) {
        Expected<Calibration> read = read_calibration(command.calibration);
        if (!read) return read.error();
        calibration = *std::move(read);
    }
    const auto host = std::make_shared<AudioHost>();
    const Expected<ChosenDevice> chosen = chosen_device(command, *host);
    if (!chosen) return chosen.error();
    if (calibration) {
        const auto other = calibration_mismatch(*calibration, chosen->info, chosen->choice.channel);
        if (!other.empty()) return Error{command.calibration.string() + ": " + other};
    }
    const auto device = open_device(host, chosen->info, chosen->choice);
    if (!device) return device.error();
    (*device)->set_level(command.level);
    announce(command, *chosen, calibration.has_value());
    const auto prepare = [&](std::size_t k) {
        return prepared(set->vibrations[(*places)[k]], calibration, command);
    };
    const auto reports =
        play_in_turn(**device, places->size(), prepare, command, interrupt.token());
    if (!reports) return reports.error();
    if (command.common.json) {
        std::cout << text_of_json(nlohmann::json{{"device", chosen->info.id},
                                                 {"channel", chosen->choice.channel},
                                                 {"level", command.level},
                                                 {"played", *reports}})
                  << "\n";
    }
    return Done{};
}

}  // namespace tact
