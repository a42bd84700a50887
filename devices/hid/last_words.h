// What is written to a controller if the program dies by a signal, is halted by one, or exits
// without having closed it: that it shall be still.
//
// A controller continues with what it was told last. When the program crashes, or is ended from
// outside, nobody is left to tell it but the signal's handler, and a handler may do little: here
// write() on a descriptor that is open already, with bytes that were laid out before. A write that
// does not return is waited for a fifth of a second.
//
// Source    signal-safety(7)
// Left out  SIGKILL and a loss of power, which nothing can answer; a halt while a driver hangs,
//           which comes once that is over.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tact {

// True once the last words are out: other threads run on for a moment, and must not write.
bool has_said_last_words();

// Holds a descriptor of its own on a device. One for each open controller; more than 16 at a time
// are not looked after.
class LastWords {
  public:
    explicit LastWords(const std::string& path);
    ~LastWords();
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;

    // Up to 80 bytes. From now on; not while another thread does the same.
    void set(std::span<const std::uint8_t> packet);

  private:
    int place_ = -1;
};

}  // namespace tact
