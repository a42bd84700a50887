#include "devices/audio/pulse_output.h"

#include <pulse/pulseaudio.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tact {

namespace {

constexpr double kOpenPatienceS = 2.0;
// The server asks for no less at a time: it is what a stop waits for.
constexpr double kPieceS = 0.005;
// A server may hold more than the buffer that it was asked for.
constexpr double kServerHoldsS = 0.25;

constexpr auto kFlags = static_cast<pa_stream_flags_t>(
    PA_STREAM_DONT_MOVE | PA_STREAM_NO_REMAP_CHANNELS | PA_STREAM_NO_REMIX_CHANNELS |
    PA_STREAM_ADJUST_LATENCY | PA_STREAM_INTERPOLATE_TIMING | PA_STREAM_AUTO_TIMING_UPDATE);

// What libpulse calls, on its thread, under its lock.
class PulseOutput {
  public:
    PulseOutput(const ServerOutput& output, double buffer_s, Playback& playback)
        : output_(output), buffer_s_(buffer_s), playback_(playback) {}
    ~PulseOutput() { close(); }
    PulseOutput(const PulseOutput&) = delete;
    PulseOutput& operator=(const PulseOutput&) = delete;

    Expected<Done> open();
    void close();
    bool is_active() const { return active_; }

  private:
    bool reach(double until_s);
    bool connect(double until_s);
    bool begin_stream();
    void ask(std::size_t bytes);
    bool write(std::size_t frames);
    bool take_back();
    double latency_s();
    pa_stream_state_t state();
    std::string fault();
    static void on_request(pa_stream*, std::size_t bytes, void* self);
    static void on_gap(pa_stream*, void* self);
    static void on_state(pa_stream* stream, void* self);
    static void on_move(pa_stream*, void* self);

    const ServerOutput output_;
    const double buffer_s_;
    Playback& playback_;
    std::atomic<bool> active_ = false;
    bool had_gap_ = false;
    std::vector<float> frames_;
    std::vector<float> written_;       // the newest frames that were, in turn
    std::uint64_t written_count_ = 0;  // of frames
    std::vector<float> instead_;       // of those that are taken back
    pa_threaded_mainloop* loop_ = nullptr;
    pa_context* context_ = nullptr;
    pa_stream* stream_ = nullptr;
};

// The map of the output itself: by name none would be mixed, and by number none is.
bool map_of(const ServerOutput& output, pa_channel_map& map) {
    pa_channel_map_init(&map);
    if (output.channels.empty() || output.channels.size() > PA_CHANNELS_MAX) return false;
    map.channels = static_cast<std::uint8_t>(output.channels.size());
    for (std::size_t k = 0; k < output.channels.size(); ++k) {
        map.map[k] = pa_channel_position_from_string(output.channels[k].c_str());
    }
    return pa_channel_map_valid(&map) != 0;
}

Expected<Done> PulseOutput::open() {
    const double until_s = steady_s() + kOpenPatienceS;
    if (!reach(until_s)) return Error{"the sound server does not answer"};
    if (connect(until_s)) return Done{};
    const std::string why = fault();
    close();
    return Error{"the sound server does not take it: " + why};
}

bool PulseOutput::reach(double until_s) {
    loop_ = pa_threaded_mainloop_new();
    if (loop_ == nullptr) return false;
    pa_threaded_mainloop_set_name(loop_, "output");
    context_ = pa_context_new(pa_threaded_mainloop_get_api(loop_), "tactspace");
    if (context_ == nullptr) return false;
    if (pa_context_connect(context_, nullptr, PA_CONTEXT_NOAUTOSPAWN, nullptr) < 0) return false;
    if (pa_threaded_mainloop_start(loop_) < 0) return false;
    for (; steady_s() < until_s; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
        pa_threaded_mainloop_lock(loop_);
        const pa_context_state_t state = pa_context_get_state(context_);
        pa_threaded_mainloop_unlock(loop_);
        if (state == PA_CONTEXT_READY) return true;
        if (PA_CONTEXT_IS_GOOD(state) == 0) return false;
    }
    return false;
}

bool PulseOutput::begin_stream() {
    pa_channel_map map;
    if (!map_of(output_, map)) return false;
    const pa_sample_spec spec{PA_SAMPLE_FLOAT32NE, output_.rate_hz, map.channels};
    if (pa_sample_spec_valid(&spec) == 0) return false;
    stream_ = pa_stream_new(context_, "pattern", &spec, &map);
    if (stream_ == nullptr) return false;
    pa_stream_set_write_callback(stream_, on_request, this);
    pa_stream_set_underflow_callback(stream_, on_gap, this);
    pa_stream_set_state_callback(stream_, on_state, this);
    pa_stream_set_moved_callback(stream_, on_move, this);
    frames_.resize(static_cast<std::size_t>(kPieceS * spec.rate) * spec.channels);
    written_.resize(static_cast<std::size_t>((buffer_s_ + kServerHoldsS) * spec.rate) *
                    spec.channels);
    instead_.reserve(written_.size());
    const auto bytes = [&](double seconds) {
        const auto frames = static_cast<std::uint32_t>(seconds * spec.rate);
        return static_cast<std::uint32_t>(frames * pa_frame_size(&spec));
    };
    constexpr auto kServers = static_cast<std::uint32_t>(-1);  // as the server has it
    const pa_buffer_attr buffer{kServers, bytes(std::max(buffer_s_, 2.0 * kPieceS)), kServers,
                                bytes(kPieceS), kServers};
    return pa_stream_connect_playback(stream_, output_.name.c_str(), &buffer, kFlags, nullptr,
                                      nullptr) >= 0;
}

// True once the stream is on that very output.
bool PulseOutput::connect(double until_s) {
    pa_threaded_mainloop_lock(loop_);
    const bool begun = begin_stream();
    pa_threaded_mainloop_unlock(loop_);
    if (!begun) return false;
    for (; steady_s() < until_s; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
        const pa_stream_state_t now = state();
        if (PA_STREAM_IS_GOOD(now) == 0) return false;
        if (now != PA_STREAM_READY) continue;
        pa_threaded_mainloop_lock(loop_);
        const char* name = pa_stream_get_device_name(stream_);
        const bool is_there = name != nullptr && output_.name == name;
        pa_threaded_mainloop_unlock(loop_);
        return is_there;
    }
    return false;
}

pa_stream_state_t PulseOutput::state() {
    pa_threaded_mainloop_lock(loop_);
    const pa_stream_state_t state = pa_stream_get_state(stream_);
    pa_threaded_mainloop_unlock(loop_);
    return state;
}

std::string PulseOutput::fault() {
    pa_threaded_mainloop_lock(loop_);
    const char* text = pa_strerror(pa_context_errno(context_));
    pa_threaded_mainloop_unlock(loop_);
    return text != nullptr ? text : "it does not say why";
}

void PulseOutput::close() {
    if (loop_ == nullptr) return;
    pa_threaded_mainloop_lock(loop_);
    if (stream_ != nullptr) {
        pa_stream_set_state_callback(stream_, nullptr, nullptr);
        pa_stream_set_write_callback(stream_, nullptr, nullptr);
        pa_stream_disconnect(stream_);
    }
    if (context_ != nullptr) pa_context_disconnect(context_);
    pa_threaded_mainloop_unlock(loop_);
    pa_threaded_mainloop_stop(loop_);
    if (stream_ != nullptr) pa_stream_unref(stream_);
    if (context_ != nullptr) pa_context_unref(context_);
    pa_threaded_mainloop_free(loop_);
    stream_ = nullptr;
    context_ = nullptr;
    loop_ = nullptr;
    active_ = false;
}

// Until what is written now is heard.
double PulseOutput::latency_s() {
    pa_usec_t latency_us = 0;
    int negative = 0;
    if (pa_stream_get_latency(stream_, &latency_us, &negative) < 0) return buffer_s_;
    return negative != 0 ? 0.0 : 1e-6 * static_cast<double>(latency_us);
}

bool PulseOutput::write(std::size_t frames) {
    const std::size_t channels = output_.channels.size();
    const std::size_t kept = written_.size() / channels;
    for (std::size_t n = 0; n < frames; ++n, ++written_count_) {
        std::copy_n(frames_.data() + n * channels, channels,
                    written_.data() + written_count_ % kept * channels);
    }
    return pa_stream_write(stream_, frames_.data(), frames * channels * sizeof(float), nullptr, 0,
                           PA_SEEK_RELATIVE) >= 0;
}

// What would be heard from kTakenBackS on is heard as a fade, and as silence behind it.
bool PulseOutput::take_back() {
    const std::size_t channels = output_.channels.size();
    const double rate_hz = playback_.layout.rate_hz;
    const double ahead = std::max(0.0, latency_s() - kTakenBackS) * rate_hz;
    const std::size_t kept = written_.size() / channels;
    const std::uint64_t count = std::min<std::uint64_t>(
        {static_cast<std::uint64_t>(ahead), static_cast<std::uint64_t>(kept), written_count_});
    instead_.assign(static_cast<std::size_t>(count) * channels, 0.0F);
    const auto fade = std::min(count, static_cast<std::uint64_t>(kRampS * rate_hz));
    for (std::uint64_t n = 0; n < fade; ++n) {
        const float gain = 1.0F - (static_cast<float>(n) + 0.5F) / static_cast<float>(fade);
        const auto at = static_cast<std::size_t>((written_count_ - count + n) % kept);
        for (std::size_t c = 0; c < channels; ++c) {
            instead_[static_cast<std::size_t>(n) * channels + c] =
                gain * written_[at * channels + c];
        }
    }
    const std::size_t bytes = instead_.size() * sizeof(float);
    if (bytes == 0) return true;
    return pa_stream_write(stream_, instead_.data(), bytes, nullptr,
                           -static_cast<std::int64_t>(bytes), PA_SEEK_RELATIVE) >= 0;
}

// In pieces of a period, so that a long buffer is answered as a short one is.
void PulseOutput::ask(std::size_t bytes) {
    const std::size_t channels = output_.channels.size();
    const double rate_hz = playback_.layout.rate_hz;
    const auto most = static_cast<std::size_t>(kPieceS * rate_hz);
    const double heard_s = steady_s() + latency_s();
    const std::size_t count = bytes / (channels * sizeof(float));
    for (std::size_t done = 0; done < count;) {
        const std::size_t now = std::min(most, count - done);
        const double ahead_s = static_cast<double>(done) / rate_hz;
        const bool goes_on = render(playback_, frames_.data(), now, heard_s + ahead_s, had_gap_);
        had_gap_ = false;
        if (goes_on ? !write(now) : !take_back()) {
            active_ = false;
            pa_stream_disconnect(stream_);
            return;
        }
        if (goes_on) done += now;
    }
}

void PulseOutput::on_request(pa_stream*, std::size_t bytes, void* self) {
    auto& output = *static_cast<PulseOutput*>(self);
    if (pa_stream_get_state(output.stream_) == PA_STREAM_READY) output.ask(bytes);
}

void PulseOutput::on_gap(pa_stream*, void* self) {
    static_cast<PulseOutput*>(self)->had_gap_ = true;
}

void PulseOutput::on_state(pa_stream* stream, void* self) {
    static_cast<PulseOutput*>(self)->active_ = pa_stream_get_state(stream) == PA_STREAM_READY;
}

// Against what was asked of the server: it shall be heard nowhere.
void PulseOutput::on_move(pa_stream*, void* self) {
    auto& output = *static_cast<PulseOutput*>(self);
    output.active_ = false;
    pa_stream_disconnect(output.stream_);
}

}  // namespace

Expected<OutputPort> open_pulse_output(const ServerOutput& output, double buffer_s,
                                       Playback& playback) {
    const auto open = std::make_shared<PulseOutput>(output, buffer_s, playback);
    const Expected<Done> opened = open->open();
    if (!opened) return opened.error();
    return OutputPort{[open] { return open->is_active(); }, [open] { open->close(); }};
}

}  // namespace tact
