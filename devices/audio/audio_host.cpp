#include "devices/audio/audio_host.h"

#include <portaudio.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <future>
#include <map>
#include <utility>

#include "devices/audio/audio_names.h"
#include "devices/audio/audio_opening.h"
#include "devices/audio/audio_stream.h"
#include "devices/audio/jack_output.h"

namespace tact {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(10);
constexpr int kMostPollsAtEnd = 100;
constexpr int kMostServerChannels = 8;

// No server is started behind a person's back, and PipeWire does not move a stream to another
// device when its own is gone. Other values that a person has set stay.
void set_environment() {
    setenv("JACK_NO_START_SERVER", "1", 0);                   // NOLINT(concurrency-mt-unsafe)
    setenv("JACK_DEFAULT_SERVER", "default", 0);              // NOLINT(concurrency-mt-unsafe)
    setenv("PULSE_PROP", "node.dont-reconnect=true", 0);      // NOLINT(concurrency-mt-unsafe)
    setenv("PIPEWIRE_PROPS", "node.dont-reconnect=true", 0);  // NOLINT(concurrency-mt-unsafe)
}

std::string interface_of(const PaDeviceInfo& device) {
    return Pa_GetHostApiInfo(device.hostApi)->name;
}

struct NumberedOutput {
    int number = -1;
    DeviceInfo info;
};

// The output of a sound server, by ALSA's configuration or by its name; empty: its usual one.
std::optional<std::string> wanted_output(const std::string& interface, const std::string& name) {
    if (interface != "ALSA") return {};
    if (auto written = server_output_behind(name)) return written;
    return is_sound_server(interface, name) ? std::optional<std::string>("") : std::nullopt;
}

void lead_to(const ServerOutput& output, DeviceInfo& info) {
    info.server_output = output.name;
    info.output_name = output.description;
    info.channels = channel_names(output.channels);
    info.rate_hz = output.rate_hz;
}

// A server takes any number of channels; where it says how many its output has, it is those. It
// is not asked where there is no `server`.
DeviceInfo info_of(const PaDeviceInfo& device, const std::string& interface, SoundServer* server) {
    DeviceInfo info;
    info.name = spoken_name(interface, device.name);
    info.interface = interface;
    const std::optional<std::string> wanted = wanted_output(interface, device.name);
    info.is_server = wanted.has_value();
    info.rate_hz = device.defaultSampleRate;
    info.latency_s = device.defaultLowOutputLatency;
    if (info.is_server && server != nullptr) {
        const auto behind =
            wanted->empty() ? server->usual_output() : server->output_named(*wanted);
        if (behind) lead_to(*behind, info);
    }
    if (!info.server_output.empty()) return info;
    const int most = info.is_server ? kMostServerChannels : device.maxOutputChannels;
    info.channels = channel_names(interface, device.name, std::min(most, device.maxOutputChannels));
    return info;
}

// The outputs of a PulseAudio server, each by itself.
std::vector<DeviceInfo> server_outputs(SoundServer& server) {
    const std::vector<ServerOutput> outputs = server.outputs();
    std::vector<DeviceInfo> infos;
    for (const ServerOutput& output : outputs) {
        DeviceInfo info;
        info.id = "audio/PulseAudio/" + output.name;
        info.interface = "PulseAudio";
        info.is_server = true;
        info.latency_s = kBufferS;
        lead_to(output, info);
        const auto alike =
            std::ranges::count(outputs, output.description, &ServerOutput::description);
        info.name = alike > 1 ? output.description + " (" + output.name + ")" : output.description;
        infos.push_back(std::move(info));
    }
    return infos;
}

std::vector<DeviceInfo> jack_devices() {
    std::vector<DeviceInfo> infos;
    for (const JackOutput& output : jack_outputs()) {
        DeviceInfo info;
        info.id = audio_id("JACK", output.client, 1);
        info.name = spoken_name("JACK", output.client);
        info.interface = "JACK";
        info.channels = channel_names("JACK", output.client, static_cast<int>(output.ports.size()));
        info.rate_hz = output.rate_hz;
        info.latency_s = output.latency_s;
        infos.push_back(std::move(info));
    }
    return infos;
}

// PortAudio, without its client of JACK's, which ends the program where a server dies and another
// one comes: it finds no server of that name. The variable is there before, so that no other thread
// sees it come or go.
bool starts_without_jack() {
    const char* const name = "JACK_DEFAULT_SERVER";
    const std::string wanted = std::getenv(name);              // NOLINT(concurrency-mt-unsafe)
    setenv(name, "none, as tactspace has its own client", 1);  // NOLINT(concurrency-mt-unsafe)
    const bool is_started = Pa_Initialize() == paNoError;
    setenv(name, wanted.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    return is_started;
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
    if (Pa_GetDeviceCount() < 0) return -1;
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
    // The list is made once, at the start of the library: a new one needs a new start.
    if (is_initialised_) Pa_Terminate();
    silence_libraries();
    const bool is_safe = has_alsa_configuration();
    is_initialised_ = is_safe && starts_without_jack();
    is_without_cards_ = !is_safe;
    listed_.clear();
    if (is_initialised_) {
        for (NumberedOutput& output : numbered_outputs(&server_))
            listed_.push_back(std::move(output.info));
    }
    for (DeviceInfo& output : jack_devices()) listed_.push_back(std::move(output));
    for (DeviceInfo& output : server_outputs(server_)) listed_.push_back(std::move(output));
    return true;
}

void AudioHost::make_room() {
    std::erase_if(open_, [](const auto& stream) {
        if (stream->is_released()) stream->close();
        return stream->is_released();
    });
}

void AudioHost::poll_streams() {
    std::erase_if(open_, [&](const auto& stream) {
        const StreamState state = stream->poll();
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
