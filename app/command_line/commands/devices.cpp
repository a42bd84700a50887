// tactspace devices: what there is to play on.

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "devices/device_list.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// As far as it is known: a sound server does not tell of what lies behind it.
std::string number_or_dash(bool is_known, double value, int digits) {
    return is_known ? fixed_digits(value, digits) : "-";
}

std::string channels_text(const DeviceInfo& device) {
    if (device.is_server && device.server_output.empty())
        return "1-" + std::to_string(device.channels.size());
    return device.channels.empty() ? "-" : std::to_string(device.channels.size());
}

// "1 front left, 2 front right".
std::string numbered(const std::vector<std::string>& channels) {
    std::string text;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        text += (k > 0 ? ", " : "") + std::to_string(k + 1) + " " + channels[k];
    }
    return text;
}

std::string table_of(const std::vector<DeviceInfo>& devices) {
    std::vector<TextRow> rows{{"device", "by", "channels", "rate Hz", "latency ms"}};
    for (const DeviceInfo& device : devices) {
        rows.push_back(
            {device.id, device.interface, channels_text(device),
             number_or_dash(!device.is_server && device.rate_hz > 0.0, device.rate_hz, 0),
             number_or_dash(device.latency_s > 0.0, 1e3 * device.latency_s, 1)});
    }
    std::string text = aligned(rows);
    for (const DeviceInfo& device : devices) {
        if (!device.server_output.empty()) {
            text += "\n" + device.id + " plays on \"" + device.server_output + "\", " +
                    device.output_name + ": " + numbered(device.channels) + "\n";
        }
        if (!device.trouble.empty()) text += "\n" + device.name + ": " + device.trouble + "\n";
    }
    return text;
}

nlohmann::json json_of(const DeviceInfo& device) {
    return {{"id", device.id},
            {"kind", device.kind == DeviceKind::audio ? "audio" : "hid"},
            {"name", device.name},
            {"interface", device.interface},
            {"channels", device.channels},
            {"is_server", device.is_server},
            {"server_output", device.server_output},
            {"output_name", device.output_name},
            {"rate_hz", device.rate_hz},
            {"latency_s", device.latency_s},
            {"trouble", device.trouble}};
}

}  // namespace

Expected<Done> run(const DevicesCommand& command) {
    AudioHost host;
    const std::vector<DeviceInfo> devices = list_devices(host);
    if (const std::string fault = cards_fault(host); !fault.empty()) {
        std::cerr << "tactspace: " << fault << "\n";
    }
    if (command.json) {
        nlohmann::json list = nlohmann::json::array();
        for (const DeviceInfo& device : devices) list.push_back(json_of(device));
        std::cout << text_of_json(list) << "\n";
    } else if (devices.empty()) {
        std::cout << "There is no device to play on. " << advice_without_devices() << "\n";
    } else {
        std::cout << table_of(devices);
    }
    return Done{};
}

}  // namespace tact
