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

}  // namespace tact
