// The game controllers and simple haptic devices that are plugged in or paired.
//
// Source    hidapi's hidraw back end (devices/hid/hid_port.h opens what is found here), sysfs; in
//           a browser WebHID, which tells no descriptor: simple haptic devices are not found there
// Left out  Switch 2 controllers, force-feedback wheels, pads over Bluetooth as sound cards.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "devices/rumble/actuator_kind.h"
#include "devices/rumble/rumble_packets.h"

namespace tact {

enum class HidBus { usb, bluetooth };

struct HidActuator {
    ActuatorKind kind = ActuatorKind::joy_con;
    HidBus bus = HidBus::usb;
    std::string name;    // "Joy-Con (L)"
    std::string path;    // /dev/hidraw3
    std::string serial;  // may be empty
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::string kernel_driver;  // that has it besides us: "nintendo"; may be empty
    Packet descriptor;          // of a simple haptic device; or empty

    bool operator==(const HidActuator&) const = default;
};

// All of them, by name and path. Some milliseconds: cheap enough to be asked once a second, from
// any thread, so that controllers come and go by themselves.
std::vector<HidActuator> hid_actuators();

// Asks the person which controllers may be used, where that is theirs to allow (hid_port.h); null:
// all that there are can be listed.
std::function<void()> controller_request();

// The same for the same controller at another port; "057e:2006", with its serial number if it has
// one, with the path if that is all there is to tell twins apart.
std::string lasting_id(const HidActuator& actuator);

// The line of a udev rule that lets the person at the screen use it.
std::string udev_rule(const HidActuator& actuator);

// The node can be opened, as far as can be told without opening it. An Error says what to do.
Expected<Done> may_be_opened(const HidActuator& actuator);

// Least time between two packets: what its bus and its firmware stand.
double packet_period_s(const HidActuator& actuator);

// Between two frames of a play: a little more, or one packet that is late would make all that
// follow it late, too.
double frame_hop_s(const HidActuator& actuator);

}  // namespace tact
