// The one thread that talks to PortAudio: it lists what there is, opens, watches and closes.
//
// PortAudio is not thread-safe, and opening a card takes long enough to stall a window. Whatever is
// to be done is posted here; the audio callback itself runs on a thread of PortAudio's.
//
// Left out  noticing new cards: the list is as of the last refresh, which needs silence.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "devices/audio/sound_server.h"
#include "devices/device/device.h"

namespace tact {

class AudioStream;

class AudioHost {
  public:
    // Before other threads, as it sets what ALSA, JACK and PulseAudio read of the environment.
    AudioHost();
    ~AudioHost();  // what plays fades out
    AudioHost(const AudioHost&) = delete;
    AudioHost& operator=(const AudioHost&) = delete;

    // The outputs there are now; as of the last time while one of them plays. Takes up to some
    // seconds: not for a thread that draws.
    std::vector<DeviceInfo> outputs();

    // Done on the thread, in order; while a stream is open it is polled in between.
    void post(std::function<void()> work);

    // On the thread only.
    void watch(std::shared_ptr<AudioStream> stream);
    bool refresh();    // false: something plays, and all stays as it is
    void make_room();  // closes what was released: a card may take one stream only
    bool is_stuck() const { return is_stuck_; }
    // From any thread: ALSA has no configuration, so that no sound card can be looked for.
    bool is_without_cards() const { return is_without_cards_; }
    SoundServer& server() { return server_; }

  private:
    void run(const std::stop_token& stop);
    void poll_streams();

    std::mutex mutex_;  // guards the next
    std::vector<std::function<void()>> waiting_;
    std::condition_variable_any changed_;
    // The thread's own.
    std::vector<std::shared_ptr<AudioStream>> open_;
    std::vector<DeviceInfo> listed_;
    SoundServer server_;
    bool is_initialised_ = false;
    std::atomic<bool> is_without_cards_ = false;
    bool is_stuck_ = false;  // in PortAudio: it can be used no more
    std::jthread thread_;    // last: ends before what it uses
};

// On the host's thread: PortAudio's number of the output of an id in its present list; -1: none.
int output_numbered(const std::string& id);

}  // namespace tact
