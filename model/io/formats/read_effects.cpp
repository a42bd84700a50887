#include "model/io/formats/read_effects.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "model/io/effects/relaxed_json.h"
#include "model/io/formats/formats.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// The first format of which this holds; null: none.
template <class Holds>
const EffectFormat* first_format(const Holds& holds) {
    for (const FormatFolder& folder : kFormatFolders) {
        const auto found = std::ranges::find_if(folder.read, holds);
        if (found != folder.read.end()) return &*found;
    }
    return nullptr;
}

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

const EffectFormat* format_of(const Json& document, std::string_view path) {
    const auto first = [&](Likeness likeness) {
        return first_format([&](const EffectFormat& format) {
            return format.likeness != nullptr && format.likeness(document, path) == likeness;
        });
    };
    const EffectFormat* certain = first(Likeness::certain);
    return certain != nullptr ? certain : first(Likeness::likely);
}

const EffectFormat* format_of_xml(std::string_view text) {
    return first_format([&](const EffectFormat& format) {
        return format.is_xml != nullptr && format.is_xml(text);
    });
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

EffectFile file_of(const std::string& path, const EffectFormat& format,
                   const std::optional<ActuatorMap>& map, Budget& budget) {
    return {path, effect_stem(path), map ? *map : bundled_actuator(format.map), budget};
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
        const EffectFormat* format = format_of_xml(text);
        if (format == nullptr) return result;
        const EffectFile file = file_of(path, *format, map, budget);
        auto effects = format->read_xml(without_bom(text), file);
        if (!effects) return effects.error();
        return EffectsRead{format, file.map, *std::move(effects)};
    }
    const auto document = document_of(text, path);
    if (!document) return document.error();
    const EffectFormat* format = format_of(document->json, path);
    if (format == nullptr) return result;
    const EffectFile file = file_of(path, *format, map, budget);
    auto effects = format->read(document->json, file);
    if (!effects) return effects.error();
    for (Effect& effect : *effects) {
        if (!document->relaxed) continue;
        effect.remarks.emplace_back("commas and quotes that JSON does not allow are tolerated");
    }
    return EffectsRead{format, file.map, *std::move(effects), about(document->json)};
}

// An ending of two dots: a file's extension is not all of it.
bool is_double(std::string_view ending) { return ending.rfind('.') != 0 && !ending.empty(); }

bool has_ending(std::string_view path, std::string_view ending) {
    if (is_double(ending)) return lower_case(std::string(path)).ends_with(ending);
    return !ending.empty() &&
           lower_case(std::filesystem::path(path).extension().string()) == ending;
}

}  // namespace

const EffectFormat* format_named(std::string_view key) {
    return first_format([&](const EffectFormat& format) { return format.key == key; });
}

std::vector<std::string> effect_endings() {
    std::vector<std::string> endings;
    for (const FormatFolder& folder : kFormatFolders) {
        for (const EffectFormat& format : folder.read) {
            if (*format.ending != '\0') endings.emplace_back(format.ending);
        }
    }
    return endings;
}

bool is_effect_name(std::string_view path) {
    return first_format([&](const EffectFormat& format) {
               return has_ending(path, format.ending);
           }) != nullptr;
}

std::string effect_stem(const std::filesystem::path& path) {
    std::string name = valid_utf8(path.filename().string());
    const EffectFormat* format = first_format([&](const EffectFormat& one) {
        const std::string_view ending = one.ending;
        return is_double(ending) && name.size() > ending.size() &&
               lower_case(name).ends_with(ending);
    });
    if (format == nullptr) return valid_utf8(path.stem().string());
    return name.substr(0, name.size() - std::string_view(format->ending).size());
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
    std::string stranger;
    first_format([&](const EffectFormat& format) {
        if (format.stranger != nullptr) stranger = format.stranger(path, head);
        return !stranger.empty();
    });
    return stranger;
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
    const char* format = read.format == nullptr ? "no effects" : read.format->name;
    text += "From " + file_name + " (" + format + "). Actuator map " + read.map.name + ": " +
            read.map.source;
    for (const std::string& remark : effect.remarks) {
        if (text.size() + remark.size() + 2 <= kMaxTextBytes) text += " " + remark + ".";
    }
    return text;
}

}  // namespace tact
