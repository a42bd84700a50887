#include "devices/audio/audio_stream.h"

#include <portaudio.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

#include "devices/audio/audio_host.h"

namespace tact {

namespace {

// A fresh PulseAudio sink was seen to start 1.3 s late.
constexpr double kStallS = 3.0;
constexpr double kLongestPollS = 0.1;
constexpr auto kClosePatience = std::chrono::seconds(1);
// Between two patterns the card stays open: the next one starts at once.
constexpr double kLingerS = 1.5;
constexpr double kWantedRateHz = 48'000.0;
constexpr double kLatencyS = 0.01;

double steady_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// PortAudio subtracts a JACK client's latency from a period without looking which is larger: what
// cannot be true counts as none.
double believable(double latency_s) {
    return latency_s >= 0.0 && latency_s < 2.0 ? latency_s : 0.0;
}

int audio_callback(const void*, void* output, unsigned long frames,
                   const PaStreamCallbackTimeInfo* time, PaStreamCallbackFlags flags, void* self) {
    render(*static_cast<Playback*>(self), static_cast<float*>(output), frames,
           time->currentTime + believable(time->outputBufferDacTime - time->currentTime),
           (flags & paOutputUnderflow) != 0);
    return paContinue;
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

std::uint64_t AudioStream::ask() {
    const std::lock_guard lock(trouble_mutex_);
    trouble_.clear();
    playback_.clipped.store(false, std::memory_order_relaxed);
    return ++asked_;
}

void AudioStream::set_level(double level) {
    playback_.level.store(static_cast<float>(level), std::memory_order_relaxed);
}

void AudioStream::stop() {
    stopped_.store(asked_.load());
    playback_.wanted.store(nullptr);
}

DeviceStatus AudioStream::status() {
    DeviceStatus status;
    status.name = place_.name;
    status.connected = connected_.load();
    status.peak = static_cast<double>(playback_.peak.exchange(0.0F));
    status.clipped = playback_.clipped.load();
    status.dropouts = playback_.dropouts.load();
    {
        const std::lock_guard lock(trouble_mutex_);
        status.trouble = trouble_;
    }
    const std::uint64_t asked = asked_.load();
    if (asked == 0 || stopped_.load() >= asked || !status.trouble.empty()) return status;
    status.playing = true;
    if (playback_.begun.load() < asked) return status;
    const double duration_s = duration_s_.load();
    const double since_s = steady_s() + clock_offset_s_.load() - playback_.origin_s.load() -
                           lead_s_.load() - place_.latency_offset_s;
    if (looping_.load()) {
        // Before the first round is heard there is none to be at the end of.
        if (duration_s <= 0.0 || (since_s < 0.0 && playback_.rounds.load() == 0)) return status;
        const double rest_s = std::fmod(since_s, duration_s);
        status.position_s = rest_s < 0.0 ? rest_s + duration_s : rest_s;
        return status;
    }
    status.position_s = std::clamp(since_s, 0.0, duration_s);
    // Rendered is not yet felt.
    status.playing = playback_.ended.load() < asked || since_s < duration_s;
    return status;
}

bool AudioStream::play(AudioHost& host, const Drive& drive, bool loop, std::uint64_t serial) {
    if (serial <= stopped_.load() || serial < asked_.load()) return stream_ != nullptr;
    if (stream_ == nullptr) {
        const Expected<Done> opened = open(host);
        connected_ = static_cast<bool>(opened);
        if (!opened) {
            tell(opened.error().message);
            return false;
        }
    }
    auto clip = std::make_unique<Clip>(clip_of(drive, playback_.layout.rate_hz, loop));
    clip->serial = serial;
    duration_s_ = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    lead_s_ = loop ? 0.0 : kClipMarginS;
    looping_ = loop;
    start(std::move(clip));
    // Stopped while it was being made ready.
    if (serial <= stopped_.load()) playback_.wanted.store(nullptr);
    return true;
}

Expected<Done> AudioStream::open(AudioHost& host) {
    if (host.is_stuck()) {
        return Error{
            "the sound server went away in a way that sound cannot be started again: "
            "start tactspace anew"};
    }
    host.make_room();
    if (output_numbered(place_.id) < 0) host.refresh();
    Expected<Done> opened = open_once();
    // A server that was started anew, a card that was taken out and put back.
    if (!opened && host.refresh()) opened = open_once();
    return opened;
}

Expected<Done> AudioStream::open_once() {
    const int number = output_numbered(place_.id);
    if (number < 0) return Error{place_.name + " is not there: plug it in, or choose another"};
    PaStreamParameters parameters{};
    parameters.device = number;
    parameters.channelCount = static_cast<int>(place_.channels);
    parameters.sampleFormat = paFloat32;
    parameters.suggestedLatency =
        std::max(kLatencyS, Pa_GetDeviceInfo(number)->defaultLowOutputLatency);
    // No callback runs: all of it may be made anew.
    playback_.layout = {rate_for(parameters), place_.channels, place_.channel, kCeiling,
                        place_.everywhere};
    playback_.own = {};
    playback_.wanted = nullptr;
    playback_.held = nullptr;
    playback_.quiet_frames = 0;
    playback_.dropouts = 0;
    PaStream* stream = nullptr;
    const PaStreamFlags flags = paClipOff | paDitherOff;
    PaError fault = Pa_OpenStream(&stream, nullptr, &parameters, playback_.layout.rate_hz,
                                  paFramesPerBufferUnspecified, flags, audio_callback, &playback_);
    if (fault != paNoError) return Error{open_fault(place_.name, fault)};
    stream_ = stream;
    fault = Pa_StartStream(stream);
    if (fault != paNoError) {
        close();
        return Error{open_fault(place_.name, fault)};
    }
    seen_calls_ = playback_.calls;
    polled_at_s_ = steady_s();
    stalled_s_ = 0.0;
    return Done{};
}

void AudioStream::start(std::unique_ptr<const Clip> clip) {
    playback_.wanted.store(clip.get());
    if (clip_) retired_.push_back({std::move(clip_), playback_.calls.load()});
    clip_ = std::move(clip);
}

// A call that was under way when a clip was replaced may still have taken it up; the second one
// after that has not.
void AudioStream::free_clips() {
    const Clip* held = playback_.held.load();
    const std::uint64_t calls = playback_.calls.load();
    std::erase_if(retired_, [&](const Retired& retired) {
        return retired.clip.get() != held && calls >= retired.at_call + 2;
    });
}

// In time that this thread was awake: a program that was halted has not lost its card.
bool AudioStream::has_stalled() {
    const std::uint64_t calls = playback_.calls.load();
    const double now_s = steady_s();
    stalled_s_ += std::clamp(now_s - polled_at_s_, 0.0, kLongestPollS);
    if (calls != seen_calls_) stalled_s_ = 0.0;
    seen_calls_ = calls;
    polled_at_s_ = now_s;
    return stalled_s_ > kStallS;
}

// The word first: PortAudio waits ten minutes for a JACK server that was killed.
StreamState AudioStream::lose() {
    if (is_sounding()) {
        connected_ = false;
        tell(place_.name + " is gone: it stopped taking sound, and nothing plays until it is back");
    }
    const auto closed = std::make_shared<std::promise<void>>();
    std::future<void> is_closed = closed->get_future();
    std::thread([stream = std::exchange(stream_, nullptr), closed] {
        Pa_AbortStream(stream);
        Pa_CloseStream(stream);
        closed->set_value();
    }).detach();
    if (is_closed.wait_for(kClosePatience) != std::future_status::ready) return StreamState::stuck;
    close();
    return StreamState::closed;
}

bool AudioStream::is_sounding() const {
    if (stream_ == nullptr || !clip_ || playback_.ended.load() >= clip_->serial) return false;
    return playback_.begun.load() >= clip_->serial || clip_->serial > stopped_.load();
}

StreamState AudioStream::poll() {
    if (stream_ == nullptr) return StreamState::closed;
    if (Pa_IsStreamActive(stream_) != 1 || has_stalled()) return lose();
    clock_offset_s_ = Pa_GetStreamTime(stream_) - steady_s();
    free_clips();
    const double latency_s = believable(Pa_GetStreamInfo(stream_)->outputLatency);
    const double quiet_s =
        static_cast<double>(playback_.quiet_frames.load()) / playback_.layout.rate_hz;
    const double enough_s = released_ ? kPadS + latency_s : kLingerS;
    if (is_sounding() || quiet_s < enough_s) return StreamState::open;
    close();
    return StreamState::closed;
}

void AudioStream::release() {
    released_ = true;
    stop();
}

// What is left to be played is silence: no need to wait for it.
void AudioStream::close() {
    if (stream_ != nullptr) {
        Pa_AbortStream(stream_);
        Pa_CloseStream(std::exchange(stream_, nullptr));
    }
    playback_.wanted = nullptr;
    clip_.reset();
    retired_.clear();
}

void AudioStream::tell(const std::string& trouble) {
    const std::lock_guard lock(trouble_mutex_);
    trouble_ = trouble;
}

}  // namespace tact
