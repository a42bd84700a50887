#include "devices/audio/audio_device.h"

#include <utility>

namespace tact {

AudioDevice::AudioDevice(std::shared_ptr<AudioHost> host, AudioStream::Place place)
    : host_(std::move(host)), stream_(std::make_shared<AudioStream>(std::move(place))) {}

AudioDevice::~AudioDevice() {
    host_->post([stream = stream_] { stream->release(); });
}

Expected<Done> AudioDevice::play(const Drive& drive, bool loop) {
    // The host outlives what is posted to it.
    host_->post([&host = *host_, stream = stream_, drive, loop, serial = stream_->ask()] {
        if (stream->play(host, drive, loop, serial)) host.watch(stream);
    });
    return Done{};
}

Expected<Done> AudioDevice::play_after(const Drive& drive, double rest_s) {
    host_->post([&host = *host_, stream = stream_, drive, rest_s, serial = stream_->ask_after()] {
        if (stream->play(host, drive, false, serial, rest_s)) host.watch(stream);
    });
    return Done{};
}

void AudioDevice::change(const Drive& drive) {
    stream_->keep_change(drive);
    host_->post([stream = stream_] { stream->change(); });
}

Expected<std::unique_ptr<Device>> open_audio(const std::shared_ptr<AudioHost>& host,
                                             const DeviceInfo& device, const DeviceChoice& choice,
                                             int channels) {
    if (choice.channel < 1 || choice.channel > channels) {
        return Error{device.name + " has no channel " + std::to_string(choice.channel) +
                     ": expected 1 to " + std::to_string(channels)};
    }
    AudioStream::Place place;
    place.id = device.id;
    place.name = device.name;
    place.channel = static_cast<std::size_t>(choice.channel - 1);
    place.channels = static_cast<std::size_t>(channels);
    place.buffer_s = choice.buffer_s;
    place.latency_offset_s = choice.latency_offset_s;
    place.everywhere = choice.everywhere;
    place.server_output = device.server_output;
    return std::unique_ptr<Device>(std::make_unique<AudioDevice>(host, std::move(place)));
}

}  // namespace tact
