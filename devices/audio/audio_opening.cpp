// How an output is opened: at which rate and in which pieces, and where a server takes it to.
#include <pa_linux_alsa.h>
#include <portaudio.h>

#include <algorithm>
#include <cmath>

#include "devices/audio/audio_host.h"
#include "devices/audio/audio_stream.h"
#include "devices/device/bounds.h"

namespace tact {

namespace {

constexpr double kWantedRateHz = 48'000.0;
// A callback each of so many parts of the buffer: it is what a stop waits for.
constexpr double kPeriodS = 0.005;

// PortAudio subtracts a JACK client's latency from a period without looking which is larger: what
// cannot be true counts as none.
double believable(double latency_s) {
    return latency_s >= 0.0 && latency_s < 2.0 ? latency_s : 0.0;
}

int audio_callback(const void*, void* output, unsigned long frames,
                   const PaStreamCallbackTimeInfo* time, PaStreamCallbackFlags flags, void* self) {
    const bool goes_on =
        render(*static_cast<Playback*>(self), static_cast<float*>(output), frames,
               time->currentTime + believable(time->outputBufferDacTime - time->currentTime),
               (flags & paOutputUnderflow) != 0);
    return goes_on ? paContinue : paAbort;
}

bool is_alsa(int number) {
    return Pa_GetHostApiInfo(Pa_GetDeviceInfo(number)->hostApi)->type == paALSA;
}

// Ahead of other work, where the system allows it to this program.
PaError start_ahead(PaStream* stream, bool is_alsa) {
    if (!is_alsa) return Pa_StartStream(stream);
    PaAlsa_EnableRealtimeScheduling(stream, 1);
    const PaError fault = Pa_StartStream(stream);
    if (fault == paNoError) return fault;
    PaAlsa_EnableRealtimeScheduling(stream, 0);
    return Pa_StartStream(stream);
}

// 48 kHz where the output takes it, as most run at it and need no second resampling.
double rate_for(const PaStreamParameters& parameters) {
    const double own_hz = Pa_GetDeviceInfo(parameters.device)->defaultSampleRate;
    if (Pa_GetHostApiInfo(Pa_GetDeviceInfo(parameters.device)->hostApi)->type == paJACK) {
        return own_hz;
    }
    const bool takes = Pa_IsFormatSupported(nullptr, &parameters, kWantedRateHz) == paNoError;
    return takes ? kWantedRateHz : own_hz;
}

std::string open_fault(const std::string& name, PaError fault) {
    if (fault == paDeviceUnavailable || fault == paUnanticipatedHostError) {
        return name +
               " is in use by another program, or gone: close what else plays there, or "
               "refresh the devices";
    }
    return name + " could not be opened: " + Pa_GetErrorText(fault);
}
}  // namespace

Expected<Done> AudioStream::open(AudioHost& host) {
    if (host.is_stuck()) {
        return Error{
            "the sound server went away in a way that sound cannot be started again: "
            "start tactspace anew"};
    }
    host.make_room();
    const std::string channel = place_.everywhere ? "" : " " + std::to_string(place_.channel);
    Expected<ActuatorLock> lock = ActuatorLock::of(place_.id + channel, place_.name);
    if (!lock) return lock.error();
    lock_ = *std::move(lock);
    if (output_numbered(place_.id) < 0) host.refresh();
    Expected<Done> opened = open_once(host.server());
    // A server that was started anew, a card that was taken out and put back.
    if (!opened && stream_ == nullptr && host.refresh()) opened = open_once(host.server());
    if (!opened) lock_ = {};
    return opened;
}

Expected<Done> AudioStream::open_once(SoundServer& server) {
    const int number = output_numbered(place_.id);
    if (number < 0) return Error{place_.name + " is not there: plug it in, or choose another"};
    PaStreamParameters parameters{};
    parameters.device = number;
    parameters.channelCount = static_cast<int>(place_.channels);
    parameters.sampleFormat = paFloat32;
    parameters.suggestedLatency =
        std::max(place_.buffer_s, Pa_GetDeviceInfo(number)->defaultLowOutputLatency);
    // No callback runs: all of it may be made anew.
    playback_.layout = {rate_for(parameters), place_.channels, place_.channel, kCeiling,
                        place_.everywhere};
    playback_.own = {};
    playback_.wanted = nullptr;
    playback_.held = nullptr;
    playback_.quiet_frames = 0;
    playback_.cut = Cut::none;
    const double periods = std::ceil(parameters.suggestedLatency / kPeriodS);
    if (is_alsa(number)) PaAlsa_SetNumPeriods(static_cast<int>(std::max(4.0, periods)));
    // At a server a stream is there as soon as it is opened.
    const std::set<std::uint32_t> before =
        is_alsa(number) ? server.own_streams() : std::set<std::uint32_t>{};
    PaStream* stream = nullptr;
    const PaStreamFlags flags = paClipOff | paDitherOff;
    const PaError fault =
        Pa_OpenStream(&stream, nullptr, &parameters, playback_.layout.rate_hz,
                      paFramesPerBufferUnspecified, flags, audio_callback, &playback_);
    if (fault != paNoError) return Error{open_fault(place_.name, fault)};
    stream_ = stream;
    playback_.layout.latency_s = believable(Pa_GetStreamInfo(stream)->outputLatency);
    Expected<Done> started = start_stream(server, before, is_alsa(number));
    if (!started) close();
    return started;
}

Expected<Done> AudioStream::start_stream(SoundServer& server, const std::set<std::uint32_t>& before,
                                         bool alsa) {
    const PaError fault = start_ahead(stream_, alsa);
    if (fault != paNoError) return Error{open_fault(place_.name, fault)};
    note_calls();
    return alsa ? find_behind(server, before) : Expected<Done>(Done{});
}

// Where a server has taken it to, and whether each channel is one of the output's own: a server
// mixes what does not match. Nothing sounds before that is known.
Expected<Done> AudioStream::find_behind(SoundServer& server,
                                        const std::set<std::uint32_t>& before) {
    server_stream_.reset();
    behind_.reset();
    for (const std::uint32_t stream : server.own_streams()) {
        if (!before.contains(stream)) server_stream_ = stream;
    }
    if (server_stream_) behind_ = server.output_of(*server_stream_);
    if (!behind_ || behind_->channels == static_cast<int>(place_.channels)) return Done{};
    return Error{place_.name + " plays on \"" + behind_->name + "\", which has " +
                 std::to_string(behind_->channels) + " channels, not " +
                 std::to_string(place_.channels) + ": it would mix them. Choose as many"};
}
}  // namespace tact
