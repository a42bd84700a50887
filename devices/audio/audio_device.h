// An actuator on an output of a sound card: voice coils on an amplifier, a DualSense by cable.
//
// Source    PortAudio 19 (ALSA), libpulse (PulseAudio, PipeWire), libjack.
// Input     a drive signal of -1..1; kept below kCeiling of full scale (devices/device/playback.h)
// Output    its sound on one channel of one output, or none at all: another output is never tried
// Left out  bit-exact output, exclusive access, sample formats other than float.
#pragma once

#include <memory>

#include "devices/audio/audio_host.h"
#include "devices/audio/audio_stream.h"
#include "devices/device/device.h"

namespace tact {

// None of its functions waits: what a play cannot do is in the trouble of a later status.
class AudioDevice final : public Device {
  public:
    AudioDevice(std::shared_ptr<AudioHost> host, AudioStream::Place place);
    // What sounds fades; the host closes the output when it is silent.
    ~AudioDevice() override;
    AudioDevice(const AudioDevice&) = delete;
    AudioDevice& operator=(const AudioDevice&) = delete;

    Expected<Done> play(const Drive& drive, bool loop) override;
    Expected<Done> play_after(const Drive& drive, double rest_s) override;
    void change(const Drive& drive) override;
    void set_level(double level) override { stream_->set_level(level); }
    void stop() override { stream_->stop(); }
    DeviceStatus status() override { return stream_->status(); }

  private:
    std::shared_ptr<AudioHost> host_;
    std::shared_ptr<AudioStream> stream_;
};

// `channels`: how many the output has there; the choice is one of them.
Expected<std::unique_ptr<Device>> open_audio(const std::shared_ptr<AudioHost>& host,
                                             const DeviceInfo& device, const DeviceChoice& choice,
                                             int channels);

}  // namespace tact
