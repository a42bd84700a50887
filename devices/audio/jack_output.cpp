#include "devices/audio/jack_output.h"

#include <jack/jack.h>

#include <algorithm>
#include <atomic>
#include <memory>

#include "devices/device/supply.h"

namespace tact {

namespace {

constexpr const char* kClientName = "tactspace";
constexpr double kLeastMissed = 0.9;  // of a period: what is later than that has missed a cycle

jack_client_t* client_of_usual_server() {
    return jack_client_open(kClientName, JackNoStartServer, nullptr);
}

double latency_s(jack_port_t* port, jack_latency_callback_mode_t mode, double rate_hz) {
    jack_latency_range_t range{};
    jack_port_get_latency_range(port, mode, &range);
    return believable_s(static_cast<double>(range.max) / rate_hz);
}

std::vector<std::string> names_in(const char** list) {
    std::vector<std::string> names;
    for (const char** each = list; each != nullptr && *each != nullptr; ++each) {
        names.emplace_back(*each);
    }
    if (list != nullptr) jack_free(static_cast<void*>(list));
    return names;
}

class JackClient {
  public:
    explicit JackClient(Playback& playback) : playback_(playback) {}
    ~JackClient() { close(); }
    JackClient(const JackClient&) = delete;
    JackClient& operator=(const JackClient&) = delete;

    Expected<Done> open(const std::vector<std::string>& ports);
    bool is_active() const;
    void close();

  private:
    bool begin(const std::vector<std::string>& ports);
    void lay_out();
    void process(jack_nframes_t frames);

    Playback& playback_;
    jack_client_t* client_ = nullptr;
    jack_port_t* port_ = nullptr;
    std::size_t connections_ = 0;
    std::atomic<bool> active_ = false;
    Supply supply_;  // the callback's own
};

Expected<Done> JackClient::open(const std::vector<std::string>& ports) {
    client_ = client_of_usual_server();
    if (client_ == nullptr) return Error{"the JACK server does not answer"};
    port_ = jack_port_register(client_, "out", JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
    if (port_ == nullptr) return close(), Error{"JACK has no room for another port"};
    if (!begin(ports)) return close(), Error{"JACK does not connect to it"};
    return Done{};
}

// The callbacks first: nothing may be set once it runs.
bool JackClient::begin(const std::vector<std::string>& ports) {
    lay_out();
    jack_set_process_callback(
        client_,
        [](jack_nframes_t frames, void* self) {
            static_cast<JackClient*>(self)->process(frames);
            return 0;
        },
        this);
    jack_on_shutdown(
        client_, [](void* self) { static_cast<JackClient*>(self)->active_ = false; }, this);
    active_ = true;
    if (jack_activate(client_) != 0) return false;
    const char* own = jack_port_name(port_);
    const auto connects = [&](const std::string& port) {
        return jack_connect(client_, own, port.c_str()) == 0;
    };
    connections_ = ports.size();
    return !ports.empty() && std::ranges::all_of(ports, connects);
}

// What JACK was given cannot be taken back: a stop is a fade, whatever the latency.
void JackClient::lay_out() {
    StreamLayout& layout = playback_.layout;
    layout.rate_hz = static_cast<double>(jack_get_sample_rate(client_));
    layout.channels = 1;
    layout.channel = 0;
    layout.latency_s = 0.0;
}

// Another program, or a person, may take the connection away.
bool JackClient::is_active() const {
    return active_.load() && jack_port_connected(port_) >= static_cast<int>(connections_);
}

// By the cycles' beginnings, which come a period apart: JACK leaves a program out of those that it
// is late for.
void JackClient::process(jack_nframes_t frames) {
    auto* const samples = static_cast<float*>(jack_port_get_buffer(port_, frames));
    const double rate_hz = playback_.layout.rate_hz;
    const double period_s = static_cast<double>(frames) / rate_hz;
    const double since_s = static_cast<double>(jack_frames_since_cycle_start(client_)) / rate_hz;
    const double begun_s = steady_s() - since_s;
    supply_.lasts_s = kLeastMissed * period_s;
    const bool has_gap = has_run_dry(supply_, begun_s, period_s);
    const double heard_s = begun_s + latency_s(port_, JackPlaybackLatency, rate_hz);
    if (active_ && render(playback_, samples, frames, heard_s, has_gap)) return;
    active_ = false;
    std::fill_n(samples, frames, 0.0F);
}

void JackClient::close() {
    if (client_ == nullptr) return;
    jack_client_close(client_);
    client_ = nullptr;
    active_ = false;
}

}  // namespace

std::vector<JackOutput> jack_outputs() {
    jack_client_t* const client = client_of_usual_server();
    if (client == nullptr) return {};
    std::vector<JackOutput> outputs;
    const auto rate_hz = static_cast<double>(jack_get_sample_rate(client));
    for (std::string& name :
         names_in(jack_get_ports(client, nullptr, JACK_DEFAULT_AUDIO_TYPE, JackPortIsInput))) {
        const std::string owner = name.substr(0, name.find(':'));
        auto output = std::ranges::find(outputs, owner, &JackOutput::client);
        if (output == outputs.end()) {
            const double late_s =
                latency_s(jack_port_by_name(client, name.c_str()), JackPlaybackLatency, rate_hz);
            output = outputs.insert(outputs.end(), {owner, {}, rate_hz, late_s});
        }
        output->ports.push_back(std::move(name));
    }
    jack_client_close(client);
    return outputs;
}

Expected<OutputPort> open_jack_output(const std::vector<std::string>& ports, Playback& playback) {
    const auto open = std::make_shared<JackClient>(playback);
    const Expected<Done> opened = open->open(ports);
    if (!opened) return opened.error();
    return OutputPort{[open] { return open->is_active(); }, [open] { open->close(); }};
}

}  // namespace tact
