// The host of a page: Web Audio asks for sound on the page's own thread, and what is posted is done
// right after that, or at once as long as nothing is open. So a stop has been answered before the
// next play comes.
//
// Left out  outputs by name, which a browser tells after a question of its own: the system's usual
//           one plays; more than two channels
#include "devices/audio/audio_host.h"

#include <emscripten.h>
#include <emscripten/eventloop.h>

#include <algorithm>
#include <utility>

#include "devices/audio/audio_stream.h"
#include "devices/device/supply.h"

// In web_sound.js.
extern "C" {
int web_sound_open(void* sound, int channels, double rate_hz, int frames);  // 0: cannot be opened
void web_sound_close(int number);
}

namespace tact {

namespace {

constexpr double kRateHz = 48'000.0;  // browsers resample where the output has another
constexpr int kFrames = 1024;         // of a piece: 21 ms
constexpr double kTimerMs = 100.0;    // where a browser holds the sound back, nobody else comes

struct WebSound {
    Playback& playback;
    bool is_active = true;
    Supply supply{};
};

// What the host does on its thread, of which there is one here.
std::function<void()>& host_turn() {
    static std::function<void()> turn;
    return turn;
}

}  // namespace

extern "C" EMSCRIPTEN_KEEPALIVE void web_sound_render(void* self, float* frames, int count,
                                                      double late_s) {
    auto& sound = *static_cast<WebSound*>(self);
    const auto size = static_cast<std::size_t>(count);
    const double now_s = steady_s();
    const double rendered_s = count / kRateHz;
    sound.supply.lasts_s = believable_s(late_s);
    const bool has_gap = has_run_dry(sound.supply, now_s, rendered_s);
    const bool goes_on = sound.is_active && render(sound.playback, frames, size,
                                                   now_s + believable_s(late_s), has_gap);
    if (!goes_on) {
        sound.is_active = false;
        std::fill_n(frames, size * sound.playback.layout.channels, 0.0F);
    }
    host_turn()();  // may close the sound: last
}

Expected<Done> AudioStream::open(AudioHost& host) {
    static const int timer =
        emscripten_set_interval([](void*) { host_turn()(); }, kTimerMs, nullptr);
    (void)timer;  // once, and not under node, which would wait for it
    host.make_room();
    if (auto alone = claim_channels(); !alone) return alone;
    lay_out(kRateHz);
    const auto sound = std::make_shared<WebSound>(WebSound{playback_});
    const int number =
        web_sound_open(sound.get(), static_cast<int>(place_.channels), kRateHz, kFrames);
    if (number == 0) {
        close();
        return Error{"this browser has no Web Audio to play by"};
    }
    port_ = OutputPort{[sound] { return sound->is_active; }, [number] { web_sound_close(number); },
                       false};
    note_calls();
    return Done{};
}

AudioHost::AudioHost() {
    host_turn() = [this] { run({}); };
}

AudioHost::~AudioHost() {
    host_turn() = [] {};
    for (const auto& stream : open_) stream->close();
}

std::vector<DeviceInfo> AudioHost::outputs() {
    DeviceInfo info;
    info.id = "audio/Web/default";
    info.name = "Sound of this device";
    info.interface = "Web Audio";
    info.channels = {"left", "right"};
    info.rate_hz = kRateHz;
    info.latency_s = 2.0 * kFrames / kRateHz;
    return {info};
}

void AudioHost::post(std::function<void()> work) {
    waiting_.push_back(std::move(work));
    if (open_.empty()) run({});
}

void AudioHost::watch(std::shared_ptr<AudioStream> stream) {
    if (std::ranges::find(open_, stream) == open_.end()) open_.push_back(std::move(stream));
}

bool AudioHost::refresh() { return true; }

void AudioHost::make_room() {
    std::erase_if(open_, [](const auto& stream) {
        if (stream->is_released()) stream->close();
        return stream->is_released();
    });
}

void AudioHost::poll_streams() {
    std::erase_if(open_, [](const auto& stream) { return stream->poll() != StreamState::open; });
}

void AudioHost::run(const std::stop_token&) {
    for (const auto& step : std::exchange(waiting_, {})) step();
    poll_streams();
}

SoundServer::~SoundServer() = default;

}  // namespace tact
