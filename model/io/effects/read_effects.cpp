#include "model/io/effects/read_effects.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "model/io/effects/effect.h"
#include "model/io/effects/relaxed_json.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::array<EffectFormatTraits, 10> kFormats{
    {{"", "no effects", "core-haptics"},
     {"ahap", "AHAP", "core-haptics"},
     {"haptic", "Meta .haptic", "quest"},
     {"hjif", "MPEG HJIF", "mpeg"},
     {"haps", "Interhaptics .haps", "interhaptics"},
     {"he", "RichTap or OpenHarmony .he", "richtap"},
     {"pulsar", "Pulsar preset", "core-haptics"},
     {"android", "Android", "android"},
     {"hla", "Hapticlabs .hla", "android"},
     {"web", "web vibration", "phone-web"}}};

char first_sign(std::string_view text) {
    const std::string_view rest = without_bom(text);
    const std::size_t first = rest.find_first_not_of(" \t\r\n\v\f");
    return first == rest.npos ? '\0' : rest[first];
}

// Whether an array does.
bool begins_with_number(std::string_view text) {
    const char second = first_sign(text.substr(text.find('[') + 1));
    return second == '-' || (second >= '0' && second <= '9');
}

// Whether an event of "Pattern" has the key, which tells AHAP from the first version of .he.
bool has_event_with(const Json& document, const char* key) {
    const Json& entries = document["Pattern"];
    if (!entries.is_array()) return false;
    return std::ranges::any_of(entries, [key](const Json& entry) {
        if (!entry.is_object()) return false;
        const auto event = entry.find("Event");
        return event != entry.end() && event->is_object() && event->contains(key);
    });
}

// Numbers and nothing else: arrays of other things are other programs'.
bool is_of_numbers(const Json& document) {
    if (!document.is_array() || document.empty()) return false;
    return std::ranges::all_of(document, [](const Json& element) { return element.is_number(); });
}

bool is_vibrate_name(std::string_view path) {
    return lower_case(std::string(path)).ends_with(kVibrateEnding);
}

EffectFormat format_of(const Json& document, std::string_view path) {
    const bool is_array_named_so = document.is_array() && is_vibrate_name(path);
    if (is_of_numbers(document) || is_array_named_so) return EffectFormat::web;
    if (!document.is_object()) return EffectFormat::none;
    const auto has = [&](const char* key) { return document.contains(key); };
    if (has("signals")) return EffectFormat::haptic;
    if (has("m_vibration") || has("m_version")) return EffectFormat::haps;
    if (has("perceptions")) return EffectFormat::hjif;
    if (has("continuousPattern") || has("discretePattern")) return EffectFormat::pulsar;
    if (has("PatternList") || (has("Channels") && (has("MetaData") || has("Metadata")))) {
        return EffectFormat::he;
    }
    if (has("Pattern")) {
        return has_event_with(document, "Type") ? EffectFormat::he : EffectFormat::ahap;
    }
    if (has("Timings")) return EffectFormat::hla;
    return has("timings") ? EffectFormat::android : EffectFormat::none;
}

Expected<Effects> read_format(EffectFormat format, const Json& document, const EffectFile& file) {
    switch (format) {
        case EffectFormat::ahap:
            return read_ahap(document, file);
        case EffectFormat::haptic:
            return read_haptic(document, file);
        case EffectFormat::hjif:
            return read_hjif(document, file);
        case EffectFormat::haps:
            return read_haps(document, file);
        case EffectFormat::he:
            return read_he(document, file);
        case EffectFormat::pulsar:
            return read_pulsar(document, file);
        case EffectFormat::android:
        case EffectFormat::hla:
            return read_timings(document, file);
        case EffectFormat::web:
            return read_vibrate(document, file);
        case EffectFormat::none:
            break;
    }
    return Effects{};
}

struct Document {
    Json json;
    bool relaxed = false;
};

// As written, or with the commas that JSON does not allow taken out.
Expected<Document> document_of(std::string_view text, const std::string& path) {
    auto strict = parse_json(text, path);
    if (strict) return Document{*std::move(strict), false};
    auto relaxed = parse_json(strict_json(without_bom(text)), path);
    if (!relaxed) return strict.error();
    return Document{*std::move(relaxed), true};
}

EffectFile file_of(const std::string& path, EffectFormat format,
                   const std::optional<ActuatorMap>& map, Budget& budget) {
    return {path, effect_stem(path), map ? *map : bundled_actuator(traits(format).map), budget};
}

bool is_vibration_xml(std::string_view text) {
    constexpr std::array<std::string_view, 4> kRoots{"<vibration-effect", "<vibration-select",
                                                     "<vibration>", "<vibration "};
    return std::ranges::any_of(kRoots,
                               [&](std::string_view root) { return text.find(root) != text.npos; });
}

// The text of the first of these keys that has one.
std::string first_text(const Json& object, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        const auto at = object.find(key);
        if (at == object.end() || !at->is_string()) continue;
        std::string text(trimmed(at->get<std::string>()));
        if (!text.empty()) return shortened(text, 1000);
    }
    return {};
}

std::string tags_of(const Json& object) {
    constexpr std::size_t kMostTags = 50;
    std::string text;
    for (const char* key : {"tags", "Tags"}) {
        const auto at = object.find(key);
        if (at == object.end() || !at->is_array()) continue;
        for (std::size_t k = 0; k < std::min(at->size(), kMostTags); ++k) {
            if (!(*at)[k].is_string()) continue;
            const std::string tag = shortened(trimmed((*at)[k].get<std::string>()));
            if (!tag.empty()) text += (text.empty() ? "" : ", ") + tag;
        }
    }
    return text;
}

// Formats keep this beside the vibration or in an object of its own.
std::string about(const Json& document) {
    std::string name;
    std::string description;
    std::string tags;
    const auto look_into = [&](const Json& object) {
        if (name.empty()) name = first_text(object, {"name", "m_name", "TrackName"});
        if (description.empty()) {
            description = first_text(object, {"description", "Description", "m_description"});
        }
        if (tags.empty()) tags = tags_of(object);
    };
    look_into(document);
    for (const char* key : {"metadata", "Metadata", "MetaData"}) {
        const auto at = document.find(key);
        if (at != document.end() && at->is_object()) look_into(*at);
    }
    std::string text = name;
    if (!description.empty()) text += (text.empty() ? "" : ": ") + description;
    if (!text.empty() && text.back() != '.') text += '.';
    if (!tags.empty()) text += (text.empty() ? "" : " ") + ("Tags: " + tags + ".");
    return text;
}

Expected<EffectsRead> read_any(std::string_view text, const std::string& path,
                               const std::optional<ActuatorMap>& map, Budget& budget) {
    EffectsRead result;
    const std::optional<std::string> decoded = utf8_of_utf16(text);
    if (decoded) text = *decoded;
    if (first_sign(text) == '<') {
        if (!is_vibration_xml(text)) return result;
        const EffectFile file = file_of(path, EffectFormat::android, map, budget);
        auto effects = read_android_xml(without_bom(text), file);
        if (!effects) return effects.error();
        return EffectsRead{EffectFormat::android, file.map, *std::move(effects)};
    }
    const auto document = document_of(text, path);
    if (!document) return document.error();
    const EffectFormat format = format_of(document->json, path);
    if (format == EffectFormat::none) return result;
    const EffectFile file = file_of(path, format, map, budget);
    auto effects = read_format(format, document->json, file);
    if (!effects) return effects.error();
    for (Effect& effect : *effects) {
        if (!document->relaxed) continue;
        effect.remarks.push_back("commas and quotes that JSON does not allow are tolerated");
    }
    return EffectsRead{format, file.map, *std::move(effects), about(document->json)};
}

}  // namespace

const EffectFormatTraits& traits(EffectFormat format) {
    return kFormats[static_cast<std::size_t>(format)];
}

const EffectFormatTraits* format_named(std::string_view key) {
    const auto found = std::ranges::find(kFormats, key, &EffectFormatTraits::key);
    return key.empty() || found == kFormats.end() ? nullptr : &*found;
}

bool is_effect_name(std::string_view path) {
    constexpr std::array<std::string_view, 6> kEndings{".ahap", ".haptic", ".hjif",
                                                       ".haps", ".he",     ".hla"};
    const std::string ending = lower_case(std::filesystem::path(path).extension().string());
    return is_vibrate_name(path) || std::ranges::find(kEndings, ending) != kEndings.end();
}

std::string effect_stem(const std::filesystem::path& path) {
    std::string name = valid_utf8(path.filename().string());
    const std::string_view ending = kVibrateEnding;
    if (name.size() <= ending.size() || !lower_case(name).ends_with(ending)) {
        return valid_utf8(path.stem().string());
    }
    return name.substr(0, name.size() - ending.size());
}

std::string head_of_effects(const std::filesystem::path& path) {
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    return none ? std::string() : head_of_effects(head_of_file(path), size);
}

std::string head_of_effects(std::string head, std::size_t size) {
    if (size > kMostEffectBytes) return {};
    if (auto decoded = utf8_of_utf16(head)) head = *std::move(decoded);
    const char first = first_sign(head);
    const bool may_be = first == '{' || first == '<' || (first == '[' && begins_with_number(head));
    return may_be ? head : std::string();
}

std::string known_stranger(const std::filesystem::path& path, std::string_view head) {
    if (lower_case(path.extension().string()) == ".vij") {
        return "is a .vij of an older Lofelt, whose format was never published: its makers' "
               "programs save it as .haptic";
    }
    const auto has = [&head](const char* key) { return head.find(key) != head.npos; };
    const bool is_of_ahap = has("\"EventType\"") || has("\"ParameterID\"");
    if (!is_of_ahap || has("\"Pattern\"")) return {};
    return "is a fragment of AHAP: expected its events in \"Pattern\"";
}

Expected<EffectsRead> read_effects(std::string_view text, const std::string& path,
                                   const std::optional<ActuatorMap>& map) {
    Budget budget;
    return read_effects(text, path, map, budget);
}

Expected<EffectsRead> read_effects(std::string_view text, const std::string& path,
                                   const std::optional<ActuatorMap>& map, Budget& budget) {
    if (text.size() > kMostEffectBytes) {
        return Error{path + ": expected an effect of at most " + grouped_digits(kMostEffectBytes) +
                     " bytes"};
    }
    return with_enough_memory(path, [&] { return read_any(text, path, map, budget); });
}

std::string origin_of(const EffectsRead& read, const Effect& effect, const std::string& file_name) {
    std::string text = read.about.empty() ? "" : read.about + " ";
    text += "From " + file_name + " (" + traits(read.format).name + "). Actuator map " +
            read.map.name + ": " + read.map.source;
    for (const std::string& remark : effect.remarks) {
        if (text.size() + remark.size() + 2 <= kMaxTextBytes) text += " " + remark + ".";
    }
    return text;
}

}  // namespace tact
