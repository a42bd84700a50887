// How one controller is spoken to: what has to be said first, and the packet of a frame.
#pragma once

#include <functional>

#include "devices/hid/hid_actuator.h"
#include "devices/hid/hid_port.h"
#include "devices/rumble/rumble_packets.h"

namespace tact {

// The packet of a frame; `counter` goes up by one a packet.
using Encoder = std::function<Packet(const RumbleFrame& frame, int counter)>;

// Wakes the controller and switches its vibration on; where a driver of the kernel has done so
// already, nothing is said. Up to a second where it does not answer. An Error says what to do.
Expected<Encoder> begin_protocol(const HidActuator& actuator, const HidPort& port);

}  // namespace tact
