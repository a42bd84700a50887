// What a PulseAudio server, or PipeWire in its place, tells of its outputs: their names, which
// channels each has, in its own order, and which one takes what does not say where it goes.
//
// Source    libpulse's asynchronous API, run by hand: it has no thread of its own here
// Left out  starting a server; playing: devices/audio/pulse_output.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

struct pa_context;
struct pa_mainloop;
struct pa_operation;

namespace tact {

struct ServerOutput {
    std::uint32_t number = 0;
    std::string name;                   // "alsa_output.usb-...": as PULSE_SINK takes it
    std::string description;            // as a person knows it
    std::vector<std::string> channels;  // their positions: "front-left", "aux0"
    std::uint32_t rate_hz = 48'000;

    bool operator==(const ServerOutput&) const = default;
};

// For one thread. Each question waits for half a second at most; without a server there is no
// answer.
class SoundServer {
  public:
    SoundServer() = default;
    ~SoundServer();
    SoundServer(const SoundServer&) = delete;
    SoundServer& operator=(const SoundServer&) = delete;

    // Where a stream goes that does not say where.
    std::optional<ServerOutput> usual_output();
    std::vector<ServerOutput> outputs();
    std::optional<ServerOutput> output_named(const std::string& name);
    // The streams of this process that make sound there.
    std::set<std::uint32_t> own_streams();
    // The output of one stream; nothing if it or the server is gone, or does not answer.
    std::optional<ServerOutput> output_of(std::uint32_t stream);

  private:
    bool reach();
    void leave();
    bool turn(double seconds);
    void await(const bool& is_there, pa_operation* asked);

    pa_mainloop* loop_ = nullptr;
    pa_context* context_ = nullptr;
};

}  // namespace tact
