// The packet that stops a controller if the program dies by a signal, is halted by one, or exits
// without having closed it.
//
// A controller continues with its last packet. When the program crashes, or is ended from outside,
// only the signal's handler can stop it, and a handler may do little: here write() on an open
// descriptor, with bytes prepared before. A write that does not return is waited for a fifth of a
// second.
//
// Source    signal-safety(7)
// Left out  SIGKILL and a loss of power, which nothing can answer; a halt while a driver hangs,
//           which comes once that is over.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tact {

// True once the packets are sent: other threads run on for a moment, and must not write.
bool has_sent_emergency_packets();

// Holds a descriptor of its own on a device. One for each open controller; more than 16 at a time
// are not looked after.
class EmergencyPacket {
  public:
    explicit EmergencyPacket(const std::string& path);
    ~EmergencyPacket();
    EmergencyPacket(const EmergencyPacket&) = delete;
    EmergencyPacket& operator=(const EmergencyPacket&) = delete;

    // Up to 80 bytes. From now on; not while another thread does the same.
    void set(std::span<const std::uint8_t> packet);

  private:
    int place_ = -1;
};

}  // namespace tact
