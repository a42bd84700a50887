#include "devices/hid/hid_port.h"

#include <hidapi.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>

#include "devices/hid/emergency_packet.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// Listing and opening share hidapi's text of the last error, which is not guarded.
std::mutex hidapi_mutex;

// An open device with what is to be said last.
struct Open {
    std::string path;
    hid_device* device = nullptr;
    EmergencyPacket emergency_packet;

    Open(std::string at, hid_device* opened)
        : path(std::move(at)), device(opened), emergency_packet(path) {}
    ~Open() {
        const std::lock_guard lock(hidapi_mutex);
        hid_close(device);
    }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
};

Packet read_report(hid_device* device, int wait_ms) {
    Packet report(512);
    const int size = hid_read_timeout(device, report.data(), report.size(), wait_ms);
    report.resize(static_cast<std::size_t>(std::max(size, 0)));
    return report;
}

Packet read_feature(hid_device* device, int number, std::size_t bytes) {
    Packet report(1 + bytes);
    report[0] = static_cast<std::uint8_t>(number);
    const int size = hid_get_feature_report(device, report.data(), report.size());
    report.resize(std::min(report.size(), static_cast<std::size_t>(std::max(size, 0))));
    return report;
}

// These names are numbers and plain letters; anything else is passed over.
std::string plain_text(const wchar_t* text) {
    std::string plain;
    for (; text != nullptr && *text != L'\0'; ++text) {
        if (*text >= L' ' && *text < 0x7F) plain += static_cast<char>(*text);
    }
    return plain;
}

// The node's place in sysfs: what the kernel says of it.
fs::path kernel_folder(const std::string& path) {
    return fs::path("/sys/class/hidraw") / fs::path(path).filename();
}

// Whether there is such a node, and the kernel knows it.
bool is_hidraw_node(const std::string& path) {
    struct stat about {};
    if (stat(path.c_str(), &about) != 0 || !S_ISCHR(about.st_mode)) return false;
    std::error_code none;
    return fs::exists(kernel_folder(path), none);
}

}  // namespace

NodeAccess access_to_node(const std::string& path) {
    if (!is_hidraw_node(path)) return NodeAccess::gone;
    return access(path.c_str(), R_OK | W_OK) == 0 ? NodeAccess::allowed : NodeAccess::denied;
}

std::string driver_of_node(const std::string& path) {
    std::error_code none;
    return fs::read_symlink(kernel_folder(path) / "device" / "driver", none).filename().string();
}

Packet descriptor_of_node(const std::string& path) {
    std::ifstream file(kernel_folder(path) / "device" / "report_descriptor", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string hid_fault() { return {}; }

std::function<void()> hid_request(std::span<const HidKind>) { return nullptr; }

void watch_hid_nodes(std::function<void()>) {}

Expected<HidPort> open_hid_port(const std::string& path) {
    // hidapi 0.13.1 touches freed memory where it fails to open what is no hidraw node.
    if (!is_hidraw_node(path)) return Error{path + ": there is no such HID device any more"};
    hid_device* device = nullptr;
    {
        const std::lock_guard lock(hidapi_mutex);
        device = hid_open_path(path.c_str());
    }
    if (device == nullptr) return Error{path + ": cannot be opened; is it in use, or just gone?"};
    const auto open = std::make_shared<Open>(path, device);
    HidPort port;
    port.write = [open](std::span<const std::uint8_t> report) {
        if (has_sent_emergency_packets()) return false;
        // A part of a report does not count: nobody knows what the controller makes of it.
        return hid_write(open->device, report.data(), report.size()) == std::ssize(report);
    };
    port.read = [open](int wait_ms) { return read_report(open->device, wait_ms); };
    port.feature = [open](int number, std::size_t bytes) {
        return read_feature(open->device, number, bytes);
    };
    port.is_there = [open] { return is_hidraw_node(open->path); };
    port.set_emergency_packet = [open](std::span<const std::uint8_t> packet) {
        open->emergency_packet.set(packet);
    };
    return port;
}

std::vector<HidNode> hid_nodes() {
    const std::lock_guard lock(hidapi_mutex);
    const std::unique_ptr<hid_device_info, void (*)(hid_device_info*)> list(hid_enumerate(0, 0),
                                                                            hid_free_enumeration);
    std::vector<HidNode> nodes;
    for (const hid_device_info* each = list.get(); each != nullptr; each = each->next) {
        nodes.push_back({each->path, plain_text(each->product_string),
                         plain_text(each->serial_number), each->vendor_id, each->product_id,
                         each->bus_type == HID_API_BUS_BLUETOOTH});
    }
    // One entry for each top-level collection of a device.
    std::ranges::sort(nodes, {}, &HidNode::path);
    const auto same = [](const HidNode& a, const HidNode& b) { return a.path == b.path; };
    nodes.erase(std::unique(nodes.begin(), nodes.end(), same), nodes.end());
    return nodes;
}

}  // namespace tact
