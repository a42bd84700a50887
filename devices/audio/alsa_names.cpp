#include "devices/audio/alsa_names.h"

#include <alsa/asoundlib.h>

namespace tact {

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
