// What PortAudio does not tell of a PulseAudio server, or of PipeWire in its place: which of its
// outputs takes our sound, how many channels that one has, and when the server moves us to another.
//
// A server moves a stream when the output it is on goes away; on the next one may hang anything.
//
// Source    libpulse's asynchronous API, run by hand: it has no thread of its own here
// Left out  starting a server; outputs of PipeWire that are reached by its own plugin of ALSA.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

struct pa_context;
struct pa_mainloop;

namespace tact {

struct ServerOutput {
    std::uint32_t number = 0;
    std::string name;  // "alsa_output.usb-...": as PULSE_SINK takes it
    int channels = 0;

    bool operator==(const ServerOutput&) const = default;
};

// Of one thread. Each question waits for half a second at most; where no server answers there is
// no answer.
class SoundServer {
  public:
    SoundServer() = default;
    ~SoundServer();
    SoundServer(const SoundServer&) = delete;
    SoundServer& operator=(const SoundServer&) = delete;

    // Where a stream goes that does not say where.
    std::optional<ServerOutput> usual_output();
    // The streams of this process that make sound there.
    std::set<std::uint32_t> own_streams();
    // Of one of them; none: it or the server is gone, or does not answer.
    std::optional<ServerOutput> output_of(std::uint32_t stream);
    // Whether anything of a stream has changed since this was asked last. Does not wait.
    bool has_changed();

  private:
    bool reach();
    void leave();
    bool turn(double seconds);

    pa_mainloop* loop_ = nullptr;
    pa_context* context_ = nullptr;
    bool changed_ = false;
};

}  // namespace tact
