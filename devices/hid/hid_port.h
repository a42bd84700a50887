// An open HID device: reports out, reports in.
//
// One file knows hidapi, and in a browser one knows WebHID; what uses a port cannot tell either
// from one that a test makes.
//
// Source    hidapi 0.13, hidraw back end: the kernel's driver keeps the device, too. WebHID of the
//           WICG (hid_port_web.cpp)
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

// `path` as it is listed. An Error if there is no such node or it cannot be opened.
Expected<HidPort> open_hid_port(const std::string& path);

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

// What the system knows of a node without opening it.
enum class NodeAccess { gone, denied, allowed };
NodeAccess access_to_node(const std::string& path);
std::string driver_of_node(const std::string& path);  // of the kernel; empty: none is known
Packet descriptor_of_node(const std::string& path);   // empty: the system does not tell it

// Why no node can be listed or opened here: a sentence; empty: they can.
std::string hid_fault();

// Where a person has to allow each device, the question to them, in the browser's own dialog: to be
// asked right after a press. Null where the system lists all by itself.
struct HidKind {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
};
std::function<void()> hid_request(std::span<const HidKind> kinds);

// Calls `changed` whenever a node has come or gone, where the system says so by itself.
void watch_hid_nodes(std::function<void()> changed);

}  // namespace tact
