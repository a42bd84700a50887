#include "devices/audio/audio_names.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <array>

namespace tact {

namespace {

constexpr std::string_view kPlace = " (hw:";

// Names from ALSA's own configuration: converters, and parts of cards under other names.
constexpr auto kAliases = std::to_array<std::string_view>(
    {"sysdefault", "front",   "rear",       "center_lfe", "side",      "iec958",
     "spdif",      "hdmi",    "modem",      "dmix",       "dsnoop",    "null",
     "jack",       "oss",     "a52",        "speex",      "phoneline", "upmix",
     "vdownmix",   "lavrate", "samplerate", "speexrate",  "usbstream"});

// Places of loudspeakers; four channels are the first four.
constexpr auto kPlaces =
    std::to_array<const char*>({"front left", "front right", "rear left", "rear right", "centre",
                                "low frequency", "side left", "side right"});

// Channels 3 and 4 move the handles' voice coils.
constexpr auto kDualSense = std::to_array<const char*>(
    {"headphone left", "headphone right", "left actuator", "right actuator"});

}  // namespace

std::string card_name(std::string_view name) {
    const std::size_t place = name.rfind(kPlace);
    const bool has_place = place != name.npos && place > 0 && name.ends_with(')');
    return std::string(has_place ? name.substr(0, place) : name);
}

std::string spoken_name(std::string_view interface, std::string_view name) {
    if (interface == "JACK") return "JACK " + std::string(name);
    if (!is_sound_server(interface, name)) return card_name(name);
    if (name == "pulse") return "PulseAudio";
    return name == "pipewire" ? "PipeWire" : "Default output";
}

bool is_alias(std::string_view interface, std::string_view name) {
    if (interface != "ALSA") return false;
    return std::ranges::find(kAliases, name) != kAliases.end() || name.starts_with("surround");
}

bool is_sound_server(std::string_view interface, std::string_view name) {
    return interface == "ALSA" && (name == "default" || name == "pulse" || name == "pipewire");
}

std::string audio_id(std::string_view interface, std::string_view name, int which) {
    std::string id = "audio/";
    id.append(interface).append("/").append(card_name(name));
    return which > 1 ? id + " " + std::to_string(which) : id;
}

std::vector<std::string> channel_names(const std::vector<std::string>& positions) {
    if (positions == std::vector<std::string>{"front-left", "front-right"}) {
        return {"left", "right"};
    }
    std::vector<std::string> names;
    for (const std::string& position : positions) {
        std::string name = position == "front-center" ? "centre"
                           : position == "lfe"        ? "low frequency"
                                                      : position;
        std::ranges::replace(name, '-', ' ');
        names.push_back(name.empty() ? std::to_string(names.size() + 1) : name);
    }
    return names;
}

std::vector<std::string> channel_names(std::string_view interface, std::string_view name,
                                       int count) {
    const bool is_dual_sense = name.find("DualSense") != name.npos && count == 4;
    std::vector<std::string> names;
    for (int channel = 0; channel < count; ++channel) {
        const auto at = static_cast<std::size_t>(channel);
        if (is_dual_sense) {
            names.emplace_back(kDualSense[at]);
        } else if (interface == "ALSA" && count == 1) {
            names.emplace_back("mono");
        } else if (interface == "ALSA" && at < kPlaces.size()) {
            names.emplace_back(count == 2 ? (at == 0 ? "left" : "right") : kPlaces[at]);
        } else {
            names.push_back(std::to_string(channel + 1));
        }
    }
    return names;
}

namespace {

constexpr int kDeepest = 4;  // names that lead on to names

std::optional<std::string> text_of(snd_config_t* in, const char* key) {
    snd_config_t* found = nullptr;
    const char* text = nullptr;
    if (snd_config_search(in, key, &found) < 0) return {};
    if (snd_config_get_string(found, &text) < 0 || text == nullptr) return {};
    return text;
}

std::optional<std::string> output_behind(const std::string& name, int depth);

// Where a plugin leads on to: to another name, or to what is written there.
std::optional<std::string> output_of(snd_config_t* definition, int depth) {
    const std::string type = text_of(definition, "type").value_or("");
    if (type == "pulse") return text_of(definition, "device").value_or("");
    const char* key = type == "plug" ? "slave.pcm" : type == "asym" ? "playback.pcm" : nullptr;
    snd_config_t* next = nullptr;
    if (key == nullptr || depth > kDeepest) return {};
    if (snd_config_search(definition, key, &next) < 0) return {};
    if (snd_config_get_type(next) == SND_CONFIG_TYPE_COMPOUND) return output_of(next, depth + 1);
    const std::optional<std::string> name = text_of(definition, key);
    return name ? output_behind(*name, depth + 1) : std::nullopt;
}

std::optional<std::string> output_behind(const std::string& name, int depth) {
    snd_config_t* definition = nullptr;
    if (snd_config_search_definition(snd_config, "pcm", name.c_str(), &definition) < 0) return {};
    std::optional<std::string> output = output_of(definition, depth);
    snd_config_delete(definition);
    return output;
}

}  // namespace

// PortAudio takes for granted that one of these two names is among the others.
bool has_alsa_configuration() {
    if (snd_config_update() < 0 || snd_config == nullptr) return false;
    snd_config_t* found = nullptr;
    return snd_config_search(snd_config, "pcm.default", &found) >= 0 ||
           snd_config_search(snd_config, "pcm.dmix", &found) >= 0;
}

std::optional<std::string> server_output_behind(const std::string& name) {
    return snd_config != nullptr ? output_behind(name, 0) : std::nullopt;
}

}  // namespace tact
