// tactspace play: patterns on an actuator, one or all of them.

#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/command_line/output.h"
#include "devices/calibration/calibration_file.h"
#include "devices/device/drive.h"
#include "devices/device_list.h"

namespace tact {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(5);

struct Chosen {
    DeviceInfo info;
    DeviceChoice choice;
};

// The device that was asked for; without a word, the only one there is.
Expected<Chosen> chosen_device(const PlayCommand& command, AudioHost& host) {
    const std::vector<DeviceInfo> devices = list_devices(host);
    // Of several none is better than another: the empty name is part of every one.
    const Expected<DeviceInfo> device = find_device(devices, command.device);
    if (!device && command.device.empty() && devices.size() > 1) {
        std::string names;
        for (const DeviceInfo& each : devices) names += "\n  --device \"" + each.id + "\"";
        return Error{"there are several devices; choose one with" + names};
    }
    if (!device) return device.error();
    Chosen chosen{*device, {}};
    chosen.choice.id = device->id;
    chosen.choice.of_channels = command.of_channels;
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

// Until it has been felt to its end.
Expected<DeviceStatus> played(Device& device, const Drive& drive, bool loop, std::stop_token stop) {
    if (const auto begun = device.play(drive, loop); !begun) return begun.error();
    const std::stop_callback silence(stop, [&device] { device.stop(); });
    for (;;) {
        const DeviceStatus status = device.status();
        if (!status.trouble.empty()) return Error{status.trouble};
        if (stop.stop_requested()) return Error{"stopped"};
        if (!status.playing) return status;
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
    if (status.clipped) {
        std::cerr << "tactspace: \"" << name
                  << "\" was too strong at this level and turned down; a larger --full-scale or a "
                     "smaller --level keeps its strength\n";
    }
    if (status.dropouts > 0) {
        std::cerr << "tactspace: \"" << name
                  << "\" had gaps: the computer was too slow to play it whole\n";
    }
}

// What the calibration makes of it, or full scale taken for so many g.
Drive drive_for(const Vibration& vibration, const std::optional<Calibration>& calibration,
                double full_scale_g) {
    const Waveform waveform = waveform_of(vibration);
    if (!calibration) return drive_of(waveform, full_scale_g);
    CalibratedDrive driven = calibrated_drive(waveform, *calibration);
    for (const std::string& warning : driven.warnings) {
        std::cerr << "tactspace: \"" << vibration.name << "\" " << warning << "\n";
    }
    return std::move(driven.drive);
}

nlohmann::json report_of(const std::string& name, const Drive& drive, const DeviceStatus& status) {
    return {{"pattern", name},
            {"duration_s", static_cast<double>(drive.samples.size()) / drive.rate_hz},
            {"clipped", status.clipped},
            {"dropouts", status.dropouts}};
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
    const Expected<Chosen> chosen = chosen_device(command, *host);
    if (!chosen) return chosen.error();
    if (calibration) {
        const auto other = calibration_mismatch(*calibration, chosen->info, chosen->choice.channel);
        if (!other.empty()) return Error{command.calibration.string() + ": " + other};
    }
    const auto device = open_device(host, chosen->info, chosen->choice);
    if (!device) return device.error();
    (*device)->set_level(command.level);
    std::cerr << "tactspace: playing on " << chosen->info.name;
    if (!chosen->info.channels.empty()) std::cerr << ", channel " << chosen->choice.channel;
    if (calibration) {
        std::cerr << ", calibrated by " << command.calibration.string() << "\n";
    } else {
        std::cerr << ", uncalibrated: full scale stands for " << command.full_scale_g << " g\n";
    }
    nlohmann::json reports = nlohmann::json::array();
    for (std::size_t k = 0; k < places->size(); ++k) {
        if (k > 0 && !waited(command.gap_s, interrupt.token())) return Error{"stopped"};
        const Vibration& vibration = set->vibrations[(*places)[k]];
        const Drive drive = drive_for(vibration, calibration, command.full_scale_g);
        if (places->size() > 1) std::cerr << "tactspace: " << vibration.name << "\n";
        const auto status = played(**device, drive, command.loop, interrupt.token());
        if (!status) return status.error();
        say(vibration.name, *status);
        reports.push_back(report_of(vibration.name, drive, *status));
    }
    if (command.common.json) {
        std::cout << nlohmann::json{{"device", chosen->info.id},
                                    {"channel", chosen->choice.channel},
                                    {"level", command.level},
                                    {"played", reports}}
                         .dump()
                  << "\n";
    }
    return Done{};
}

}  // namespace tact
