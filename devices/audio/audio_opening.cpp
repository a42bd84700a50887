#include "devices/audio/audio_opening.h"

#include <alsa/asoundlib.h>
#include <jack/jack.h>
#include <pa_linux_alsa.h>
#include <portaudio.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>
#include <utility>

#include "devices/audio/audio_host.h"
#include "devices/audio/audio_names.h"
#include "devices/audio/audio_stream.h"
#include "devices/audio/jack_output.h"
#include "devices/audio/pulse_output.h"
#include "devices/device/supply.h"

namespace tact {

// How an output is opened: at which rate, in which pieces, and by nobody else.

namespace {

constexpr double kWantedRateHz = 48'000.0;
constexpr std::string_view kJackIds = "audio/JACK/";
// Time between callbacks, a part of the buffer: a stop waits for the next one.
constexpr double kPeriodS = 0.005;

Error other_channels(const std::string& on, std::size_t now, std::size_t chosen) {
    return Error{on + " has " + std::to_string(now) + " channels now, not " +
                 std::to_string(chosen) + ": refresh the devices and choose its channel again"};
}

// A card says itself where sound was missing; what lies behind a server's name does not.
struct CardCallback {
    Playback& playback;
    bool tells_gaps = true;
    Supply supply{};
};

// By the steady clock: PortAudio's is the time of day, which may be set while something plays.
int audio_callback(const void*, void* output, unsigned long frames,
                   const PaStreamCallbackTimeInfo* time, PaStreamCallbackFlags flags, void* self) {
    auto& called = *static_cast<CardCallback*>(self);
    const double now_s = steady_s();
    const double rendered_s = static_cast<double>(frames) / called.playback.layout.rate_hz;
    const bool is_dry = has_run_dry(called.supply, now_s, rendered_s) && !called.tells_gaps;
    const bool goes_on = render(called.playback, static_cast<float*>(output), frames,
                                now_s + believable_s(time->outputBufferDacTime - time->currentTime),
                                is_dry || (flags & paOutputUnderflow) != 0);
    return goes_on ? paContinue : paAbort;
}

bool is_alsa(int number) {
    return Pa_GetHostApiInfo(Pa_GetDeviceInfo(number)->hostApi)->type == paALSA;
}

bool is_server(int number) {
    return is_alsa(number) && is_sound_server("ALSA", Pa_GetDeviceInfo(number)->name);
}

OutputPort port_of(PaStream* stream, std::shared_ptr<CardCallback> callback) {
    return {[stream] { return Pa_IsStreamActive(stream) == 1; },
            [stream, callback = std::move(callback)] {
                Pa_AbortStream(stream);
                Pa_CloseStream(stream);
            }};
}

// 48 kHz where the output takes it, as most run at it and need no second resampling.
double rate_for(const PaStreamParameters& parameters) {
    const double own_hz = Pa_GetDeviceInfo(parameters.device)->defaultSampleRate;
    const bool takes = Pa_IsFormatSupported(nullptr, &parameters, kWantedRateHz) == paNoError;
    return takes ? kWantedRateHz : own_hz;
}

std::string open_fault(const std::string& name, PaError fault) {
    if (fault == paDeviceUnavailable || fault == paUnanticipatedHostError) {
        return name +
               " is in use by another program, or gone: close the other program, or "
               "refresh the devices";
    }
    return name + " could not be opened: " + Pa_GetErrorText(fault);
}

// Ahead of other work, where the system allows it to this program.
Expected<Done> start_ahead(PaStream* stream, bool is_alsa, const std::string& name) {
    if (is_alsa) PaAlsa_EnableRealtimeScheduling(stream, 1);
    PaError fault = Pa_StartStream(stream);
    if (fault != paNoError && is_alsa) {
        PaAlsa_EnableRealtimeScheduling(stream, 0);
        fault = Pa_StartStream(stream);
    }
    if (fault != paNoError) return Error{open_fault(name, fault)};
    return Done{};
}

}  // namespace

Expected<Done> AudioStream::open(AudioHost& host) {
    if (host.is_stuck()) {
        return Error{
            "the sound server went away in a way that sound cannot be started again: "
            "start tactspace again"};
    }
    host.make_room();
    if (auto alone = claim_channels(); !alone) return alone;
    if (!place_.server_output.empty()) {
        Expected<Done> opened = open_at_server(host.server());
        if (!opened) close();
        return opened;
    }
    if (place_.id.starts_with(kJackIds)) {
        Expected<Done> opened = open_at_jack();
        if (!opened) close();
        return opened;
    }
    if (output_numbered(place_.id) < 0) host.refresh();
    Expected<Done> opened = open_once(host.server());
    // A server that was restarted, a card that was taken out and put back.
    if (!opened && !port_ && host.refresh()) opened = open_once(host.server());
    if (!opened) close();
    return opened;
}

// On that output as it was when it was chosen, and on no other one.
Expected<Done> AudioStream::open_at_server(SoundServer& server) {
    const std::string on = place_.name + " on \"" + place_.server_output + "\"";
    const std::optional<ServerOutput> output = server.output_named(place_.server_output);
    if (!output) {
        return Error{on +
                     " is not there: bring it back, or refresh the devices and choose another"};
    }
    if (output->channels.size() != place_.channels) {
        return other_channels(on, output->channels.size(), place_.channels);
    }
    lay_out(output->rate_hz);
    playback_.layout.latency_s = place_.buffer_s;
    playback_.layout.takes_back = true;
    Expected<OutputPort> port = open_pulse_output(*output, place_.buffer_s, playback_);
    if (!port) return Error{on + " could not be opened: " + port.error().message};
    port_ = *std::move(port);
    note_calls();
    return Done{};
}

Expected<Done> AudioStream::open_at_jack() {
    const auto outputs = jack_outputs();
    const auto output =
        std::ranges::find(outputs, place_.id.substr(kJackIds.size()), &JackOutput::client);
    if (output == outputs.end()) {
        return Error{place_.name + " is not there: bring it back, or choose another"};
    }
    if (output->ports.size() != place_.channels) {
        return other_channels(place_.name, output->ports.size(), place_.channels);
    }
    lay_out(output->rate_hz);
    std::vector<std::string> ports = output->ports;
    if (!place_.everywhere) ports = {ports[place_.channel]};
    Expected<OutputPort> port = open_jack_output(ports, playback_);
    if (!port) return Error{place_.name + " could not be opened: " + port.error().message};
    port_ = *std::move(port);
    note_calls();
    return Done{};
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
    lay_out(rate_for(parameters));
    const double periods = std::ceil(parameters.suggestedLatency / kPeriodS);
    if (is_alsa(number)) PaAlsa_SetNumPeriods(static_cast<int>(std::max(4.0, periods)));
    // At a server a stream is there as soon as it is opened.
    const std::set<std::uint32_t> before =
        is_alsa(number) ? server.own_streams() : std::set<std::uint32_t>{};
    const auto callback = std::make_shared<CardCallback>(
        CardCallback{playback_, is_alsa(number) && !is_server(number)});
    PaStream* stream = nullptr;
    const PaStreamFlags flags = paClipOff | paDitherOff;
    const PaError fault =
        Pa_OpenStream(&stream, nullptr, &parameters, playback_.layout.rate_hz,
                      paFramesPerBufferUnspecified, flags, audio_callback, callback.get());
    if (fault != paNoError) return Error{open_fault(place_.name, fault)};
    port_ = port_of(stream, callback);
    playback_.layout.latency_s = believable_s(Pa_GetStreamInfo(stream)->outputLatency);
    callback->supply.lasts_s = playback_.layout.latency_s;
    Expected<Done> started = start_ahead(stream, is_alsa(number), place_.name);
    note_calls();
    if (started && is_alsa(number)) started = is_direct(server, before);
    if (!started) {
        port_->close();
        port_.reset();
    }
    return started;
}

// A name of ALSA's that leads to a sound server under a name that does not tell: the server would
// mix its channels by their positions, and may move it. Nothing sounds before that is known.
Expected<Done> AudioStream::is_direct(SoundServer& server,
                                      const std::set<std::uint32_t>& before) const {
    for (const std::uint32_t stream : server.own_streams()) {
        if (before.contains(stream)) continue;
        const std::optional<ServerOutput> behind = server.output_of(stream);
        if (!behind) continue;
        return Error{
            place_.name + " leads to \"" + behind->name +
            "\" of the sound server, which may mix and move it: choose that output itself"};
    }
    return Done{};
}

namespace {

void ignore_alsa(const char*, int, const char*, int, const char*, ...) {}
void ignore_jack(const char*) {}

#ifdef __GLIBC__
// One call of fprintf is one piece: the stream is not buffered.
ssize_t pass_on(void*, const char* text, std::size_t size) {
    if (std::string_view(text, size).starts_with("Expression '")) return static_cast<ssize_t>(size);
    return ::write(STDERR_FILENO, text, size);
}
#endif

}  // namespace

void filter_standard_error() {
#ifdef __GLIBC__
    cookie_io_functions_t functions{};
    functions.write = pass_on;
    FILE* filtered = fopencookie(nullptr, "w", functions);
    if (filtered == nullptr) return;
    std::setvbuf(filtered, nullptr, _IONBF, 0);
    stderr = filtered;  // a variable, in glibc
#endif
}

void silence_libraries() {
    snd_lib_error_set_handler(ignore_alsa);
    jack_set_error_function(ignore_jack);
    jack_set_info_function(ignore_jack);
}

}  // namespace tact
