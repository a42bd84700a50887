// One output of a sound card, from the play that opens it until some time after the last one.
//
// Between three threads: a person's (stop, level, status), the host's, which opens and watches,
// and the callback's, which has to do with devices/device/playback.h alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "devices/audio/output_port.h"
#include "devices/audio/sound_server.h"
#include "devices/device/actuator_lock.h"
#include "devices/device/device.h"
#include "devices/device/playback.h"

namespace tact {

class AudioHost;

// `stuck`: its library does not come back from closing it. It has to be kept as it is until the
// program ends, and the library not be spoken to again.
enum class StreamState { open, closed, stuck };

class AudioStream {
  public:
    // `channel` of `channels`, counted from 0.
    struct Place {
        std::string id;
        std::string name;  // for sentences
        std::size_t channel = 0;
        std::size_t channels = 2;
        double latency_offset_s = 0.0;
        bool everywhere = false;  // on all channels instead
        double buffer_s = kBufferS;
        std::string server_output{};  // of a sound server: that one and no other
    };

    explicit AudioStream(Place place) : place_(std::move(place)) {}

    // For any one thread. ask() gives the serial of a play to come, in place of all others;
    // ask_after() that of one after them.
    std::uint64_t ask();
    std::uint64_t ask_after();
    void set_level(double level);
    void stop();
    DeviceStatus status();

    // For the host's thread.
    // True: it is open, and needs to be polled. `rest_s`: after the end of what plays.
    bool play(AudioHost& host, const Drive& drive, bool loop, std::uint64_t serial,
              std::optional<double> rest_s = {});
    StreamState poll();
    // What the play of that serial, a loop, is changed into, the newest alone: of any one thread,
    // then of the host's.
    void keep_change(const Drive& drive);
    void change();
    void release();            // stops, and closes after a last silence
    void close();              // at once
    bool is_sounding() const;  // or about to, or fading
    bool is_released() const { return released_; }

  private:
    struct Retired {
        std::unique_ptr<const Clip> clip;
        std::uint64_t at_call = 0;
    };

    struct Change {
        Drive drive;
        std::uint64_t serial = 0;  // of the play that is changed
    };

    // A play behind one that waits itself.
    struct Behind {
        Drive drive;
        std::uint64_t serial = 0;
        double rest_s = 0.0;
    };

    // A play that was asked for, until it has been felt to its end.
    struct Asked {
        std::uint64_t serial = 0;
        double duration_s = 0.0;
        double lead_s = 0.0;  // of the clip, before the pattern in it
        bool looping = false;
    };

    DeviceStatus status_of(const Asked& asked, DeviceStatus status);
    Expected<Done> open(AudioHost& host);
    Expected<Done> open_once(SoundServer& server);
    void note_calls();
    Expected<Done> open_at_server(SoundServer& server);
    Expected<Done> open_at_jack();
    Expected<Done> is_direct(SoundServer& server, const std::set<std::uint32_t>& before) const;
    Expected<Done> claim_channels();
    void lay_out(double rate_hz);
    void begin(const Drive& drive, bool loop, std::uint64_t serial, std::optional<double> rest_s,
               bool is_new);
    bool has_one_waiting() const;
    void take_behind();
    void wait_out(Clip& clip, double rest_s) const;
    void settle_cut();
    void rest_if_halted();
    void start(std::unique_ptr<const Clip> clip, double duration_s);
    void free_clips();
    void tell(const std::string& trouble);
    bool has_stalled();
    StreamState lose(const std::string& why);

    const Place place_;
    Playback playback_;
    std::atomic<std::uint64_t> asked_ = 0;
    std::atomic<std::uint64_t> superseded_ = 0;  // all before this one
    std::atomic<std::uint64_t> stopped_ = 0;     // this play and all before it
    std::atomic<bool> connected_ = true;
    std::atomic<std::uint64_t> halts_ = 0;  // of the program, when the newest play was asked for
    std::mutex mutex_;                      // guards the next four
    std::optional<Change> change_;
    std::string trouble_;
    std::vector<Asked> plays_;   // the one to be felt now, and what waits for its end
    bool has_told_end_ = false;  // of the only one

    // The host's thread's own.
    std::optional<OutputPort> port_;
    std::unique_ptr<const Clip> clip_;
    std::optional<Behind> behind_;
    std::vector<Retired> retired_;
    std::vector<ActuatorLock> locks_;  // of each channel that sounds
    bool released_ = false;
    std::uint64_t seen_calls_ = 0;
    double polled_at_s_ = 0.0;
    double stalled_s_ = 0.0;  // without a call
    double linger_s_ = 0.0;
    double last_end_s_ = 0.0;  // of the last play, by the steady clock, or a little later
};

}  // namespace tact
