#include "devices/audio/audio_host.h"

#include <pa_jack.h>
#include <portaudio.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <future>
#include <map>
#include <utility>

#include "devices/audio/audio_names.h"
#include "devices/audio/audio_stream.h"
#include "devices/audio/library_noise.h"

namespace tact {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(10);
constexpr int kMostPollsAtEnd = 100;
constexpr int kMostServerChannels = 8;

// No server is started behind a person's back, and PipeWire does not move a stream to another
// device when its own is gone. Other values that a person has set stay.
void set_environment() {
    setenv("JACK_NO_START_SERVER", "1", 0);                   // NOLINT(concurrency-mt-unsafe)
    setenv("PULSE_PROP", "node.dont-reconnect=true", 0);      // NOLINT(concurrency-mt-unsafe)
    setenv("PIPEWIRE_PROPS", "node.dont-reconnect=true", 0);  // NOLINT(concurrency-mt-unsafe)
}

std::string interface_of(const PaDeviceInfo& device) {
    const PaHostApiInfo* api = Pa_GetHostApiInfo(device.hostApi);
    if (api->type == paJACK) return "JACK";
    return api->name;
}

struct NumberedOutput {
    int number = -1;
    DeviceInfo info;
};

// A server takes any number of channels; where it says how many its output has, it is those. It
// is not asked where there is no `server`.
DeviceInfo info_of(const PaDeviceInfo& device, const std::string& interface, SoundServer* server) {
    DeviceInfo info;
    info.name = spoken_name(interface, device.name);
    info.interface = interface;
    info.is_server = is_sound_server(interface, device.name);
    int channels = device.maxOutputChannels;
    if (info.is_server) {
        const bool is_asked = server != nullptr && std::string(device.name) != "pipewire";
        const auto behind = is_asked ? server->usual_output() : std::nullopt;
        channels = std::min(channels, behind ? behind->channels : kMostServerChannels);
        if (behind) info.server_output = behind->name;
    }
    info.channels = channel_names(interface, device.name, channels);
    info.rate_hz = device.defaultSampleRate;
    info.latency_s = device.defaultLowOutputLatency;
    return info;
}

// ALSA's "default" where it leads to a server that is listed by its own name.
bool is_second_name(const std::string& interface, const std::string& name) {
    if (interface != "ALSA" || name != "default") return false;
    for (int number = 0; number < Pa_GetDeviceCount(); ++number) {
        const std::string other = Pa_GetDeviceInfo(number)->name;
        if (other != name && is_sound_server("ALSA", other)) return true;
    }
    return false;
}

std::vector<NumberedOutput> numbered_outputs(SoundServer* server) {
    std::vector<NumberedOutput> outputs;
    std::map<std::string, int> alike;
    for (int number = 0; number < Pa_GetDeviceCount(); ++number) {
        const PaDeviceInfo& device = *Pa_GetDeviceInfo(number);
        const std::string interface = interface_of(device);
        if (device.maxOutputChannels < 1 || is_alias(interface, device.name)) continue;
        if (is_second_name(interface, device.name)) continue;
        NumberedOutput output{number, info_of(device, interface, server)};
        const int which = ++alike[audio_id(interface, device.name, 1)];
        output.info.id = audio_id(interface, device.name, which);
        if (which > 1) output.info.name += " " + std::to_string(which);
        outputs.push_back(std::move(output));
    }
    return outputs;
}

}  // namespace

int output_numbered(const std::string& id) {
    for (const NumberedOutput& output : numbered_outputs(nullptr)) {
        if (output.info.id == id) return output.number;
    }
    return -1;
}

AudioHost::AudioHost() {
    set_environment();
    filter_standard_error();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

AudioHost::~AudioHost() = default;

std::vector<DeviceInfo> AudioHost::outputs() {
    std::promise<std::vector<DeviceInfo>> answer;
    post([&] {
        refresh();
        answer.set_value(listed_);
    });
    return answer.get_future().get();
}

void AudioHost::post(std::function<void()> work) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(work));
    }
    changed_.notify_one();
}

void AudioHost::watch(std::shared_ptr<AudioStream> stream) {
    if (std::ranges::find(open_, stream) == open_.end()) open_.push_back(std::move(stream));
}

bool AudioHost::refresh() {
    if (is_stuck_) return false;
    for (const auto& stream : open_) {
        if (stream->is_sounding()) return false;
    }
    for (const auto& stream : open_) stream->close();
    open_.clear();
    // The list is made once, at the start of the library: for a new one it has to start anew.
    if (is_initialised_) Pa_Terminate();
    silence_libraries();
    PaJack_SetClientName("tactspace");
    is_initialised_ = Pa_Initialize() == paNoError;
    listed_.clear();
    if (!is_initialised_) return true;
    for (NumberedOutput& output : numbered_outputs(&server_))
        listed_.push_back(std::move(output.info));
    return true;
}

void AudioHost::make_room() {
    std::erase_if(open_, [](const auto& stream) {
        if (stream->is_released()) stream->close();
        return stream->is_released();
    });
}

void AudioHost::poll_streams() {
    const bool changed = server_.has_changed();
    std::erase_if(open_, [&](const auto& stream) {
        const StreamState state = stream->poll(server_, changed);
        if (state == StreamState::stuck) {
            is_stuck_ = true;
            // Whoever is stuck there may still look at it.
            new std::shared_ptr<AudioStream>(stream);
        }
        return state != StreamState::open;
    });
}

void AudioHost::run(const std::stop_token& stop) {
    for (;;) {
        std::vector<std::function<void()>> work;
        {
            std::unique_lock lock(mutex_);
            const auto has_work = [this] { return !waiting_.empty(); };
            if (open_.empty()) {
                changed_.wait(lock, stop, has_work);
            } else {
                changed_.wait_for(lock, stop, kPoll, has_work);
            }
            work.swap(waiting_);
        }
        for (const auto& step : work) step();
        poll_streams();
        if (stop.stop_requested() && work.empty()) break;
    }
    // What sounds fades, and its last silence is played, if that is soon.
    for (const auto& stream : open_) stream->release();
    for (int round = 0; round < kMostPollsAtEnd && !open_.empty(); ++round) {
        poll_streams();
        std::this_thread::sleep_for(kPoll);
    }
    if (is_stuck_) return;
    for (const auto& stream : open_) stream->close();
    if (is_initialised_) Pa_Terminate();
}

}  // namespace tact
