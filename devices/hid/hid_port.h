// An open HID device: reports out, reports in.
//
// The one file that knows hidapi. What uses a port cannot tell it from one that a test makes.
//
// Source    hidapi 0.13, hidraw back end: the kernel's driver keeps the device, too
// Left out  input events, serial numbers that are changed
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "devices/rumble/rumble_packets.h"
#include "model/common/expected.h"

namespace tact {

// From one thread at a time. All may be called after the device is gone.
struct HidPort {
    // A report, its number first. False: it was not taken whole.
    std::function<bool(std::span<const std::uint8_t>)> write;
    // The next report that comes within a number of milliseconds; empty: none did.
    std::function<Packet(int)> read;
    // A feature report of a number and a length without it; empty: no such report.
    std::function<Packet(int, std::size_t)> feature;
    // False once it is unplugged or out of reach.
    std::function<bool()> is_there;
    // What is written should the program crash.
    std::function<void(std::span<const std::uint8_t>)> set_emergency_packet;
};

// `path` as it is listed. An Error if it is no hidraw node or cannot be opened.
Expected<HidPort> open_hid_port(const std::string& path);

// Whether there is such a node, and the kernel knows it.
bool is_hidraw_node(const std::string& path);

// A node as hidapi lists it.
struct HidNode {
    std::string path;
    std::string name;
    std::string serial;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    bool is_bluetooth = false;
};

// By path, each once.
std::vector<HidNode> hid_nodes();

}  // namespace tact
