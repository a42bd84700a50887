#include "devices/audio/sound_server.h"

#include <pulse/pulseaudio.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace tact {

namespace {

constexpr double kPatienceS = 0.5;

double now_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// An answer on its way; libpulse fills it in while the loop turns.
template <class Value>
struct Answer {
    Value value{};
    bool is_there = false;
};

ServerOutput output_of_info(const pa_sink_info& info) {
    ServerOutput output;
    output.number = info.index;
    output.name = info.name;
    output.description = info.description != nullptr ? info.description : info.name;
    for (std::uint8_t k = 0; k < info.channel_map.channels; ++k) {
        const char* position = pa_channel_position_to_string(info.channel_map.map[k]);
        output.channels.emplace_back(position != nullptr ? position : "");
    }
    output.rate_hz = info.sample_spec.rate;
    return output;
}

void take_output(pa_context*, const pa_sink_info* info, int end, void* self) {
    auto& answer = *static_cast<Answer<std::optional<ServerOutput>>*>(self);
    if (info != nullptr) answer.value = output_of_info(*info);
    if (end != 0) answer.is_there = true;
}

void take_outputs(pa_context*, const pa_sink_info* info, int end, void* self) {
    auto& answer = *static_cast<Answer<std::vector<ServerOutput>>*>(self);
    if (info != nullptr) answer.value.push_back(output_of_info(*info));
    if (end != 0) answer.is_there = true;
}

void take_usual(pa_context*, const pa_server_info* info, void* self) {
    auto& answer = *static_cast<Answer<std::string>*>(self);
    if (info != nullptr && info->default_sink_name != nullptr) {
        answer.value = info->default_sink_name;
    }
    answer.is_there = true;
}

void take_streams(pa_context*, const pa_sink_input_info* info, int end, void* self) {
    auto& answer = *static_cast<Answer<std::set<std::uint32_t>>*>(self);
    if (end != 0) answer.is_there = true;
    if (info == nullptr) return;
    const char* owner = pa_proplist_gets(info->proplist, PA_PROP_APPLICATION_PROCESS_ID);
    if (owner != nullptr && std::atol(owner) == getpid()) answer.value.insert(info->index);
}

void take_stream(pa_context*, const pa_sink_input_info* info, int end, void* self) {
    auto& answer = *static_cast<Answer<std::optional<std::uint32_t>>*>(self);
    if (info != nullptr) answer.value = info->sink;
    if (end != 0) answer.is_there = true;
}

// An operation that is let go of takes its answer along: that may not live any more.
void let_go(pa_operation* operation) {
    if (operation == nullptr) return;
    if (pa_operation_get_state(operation) == PA_OPERATION_RUNNING) pa_operation_cancel(operation);
    pa_operation_unref(operation);
}

}  // namespace

SoundServer::~SoundServer() { leave(); }

void SoundServer::leave() {
    if (context_ != nullptr) {
        pa_context_disconnect(context_);
        pa_context_unref(context_);
        context_ = nullptr;
    }
    if (loop_ != nullptr) pa_mainloop_free(loop_);
    loop_ = nullptr;
}

// Whatever is due, or the first thing that is within `seconds`. False: the server is gone.
bool SoundServer::turn(double seconds) {
    const int wait_us = static_cast<int>(1e6 * std::max(0.0, seconds));
    if (pa_mainloop_prepare(loop_, wait_us) < 0 || pa_mainloop_poll(loop_) < 0) return false;
    if (pa_mainloop_dispatch(loop_) < 0) return false;
    return PA_CONTEXT_IS_GOOD(pa_context_get_state(context_)) != 0;
}

bool SoundServer::reach() {
    if (context_ != nullptr && PA_CONTEXT_IS_GOOD(pa_context_get_state(context_)) != 0) return true;
    leave();
    loop_ = pa_mainloop_new();
    if (loop_ == nullptr) return false;
    context_ = pa_context_new(pa_mainloop_get_api(loop_), "tactspace, watching");
    if (context_ == nullptr) return false;
    if (pa_context_connect(context_, nullptr, PA_CONTEXT_NOAUTOSPAWN, nullptr) < 0) return false;
    const double until_s = now_s() + kPatienceS;
    while (pa_context_get_state(context_) != PA_CONTEXT_READY) {
        if (now_s() >= until_s || !turn(until_s - now_s())) return leave(), false;
    }
    return true;
}

// Until there is an answer, or for as long as one is waited for.
void SoundServer::await(const bool& is_there, pa_operation* asked) {
    const double until_s = now_s() + kPatienceS;
    while (!is_there && now_s() < until_s && turn(until_s - now_s())) continue;
    let_go(asked);
}

std::optional<ServerOutput> SoundServer::usual_output() {
    if (!reach()) return {};
    Answer<std::string> name;
    // As libpulse itself would choose.
    const char* wanted = std::getenv("PULSE_SINK");  // NOLINT(concurrency-mt-unsafe)
    if (wanted != nullptr && *wanted != '\0') {
        name.value = wanted;
    } else {
        await(name.is_there, pa_context_get_server_info(context_, take_usual, &name));
    }
    return name.value.empty() ? std::nullopt : output_named(name.value);
}

std::vector<ServerOutput> SoundServer::outputs() {
    if (!reach()) return {};
    Answer<std::vector<ServerOutput>> outputs;
    await(outputs.is_there, pa_context_get_sink_info_list(context_, take_outputs, &outputs));
    return outputs.value;
}

std::optional<ServerOutput> SoundServer::output_named(const std::string& name) {
    if (!reach()) return {};
    Answer<std::optional<ServerOutput>> output;
    await(output.is_there,
          pa_context_get_sink_info_by_name(context_, name.c_str(), take_output, &output));
    return output.value;
}

std::set<std::uint32_t> SoundServer::own_streams() {
    if (!reach()) return {};
    Answer<std::set<std::uint32_t>> streams;
    await(streams.is_there, pa_context_get_sink_input_info_list(context_, take_streams, &streams));
    return streams.value;
}

std::optional<ServerOutput> SoundServer::output_of(std::uint32_t stream) {
    if (!reach()) return {};
    Answer<std::optional<std::uint32_t>> sink;
    await(sink.is_there, pa_context_get_sink_input_info(context_, stream, take_stream, &sink));
    if (!sink.value) return {};
    Answer<std::optional<ServerOutput>> output;
    await(output.is_there,
          pa_context_get_sink_info_by_index(context_, *sink.value, take_output, &output));
    return output.value;
}

}  // namespace tact
