// How a format of effects is told from others, and how its files are read. The folder of a format
// describes it so, and model/io/formats/formats.h has a row for each folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/io/effects/effect.h"

namespace tact {

// Whether a document is of a format. Formats that are certain come before those that are likely:
// these go by a key that documents of others have, too.
enum class Likeness { none, likely, certain };

// A format has the two functions of JSON, those of XML or all four.
struct EffectFormat {
    const char* key = "";     // "haptic"
    const char* name = "";    // "Meta .haptic"
    const char* map = "";     // of actuator_map.h, where nobody chooses another
    const char* ending = "";  // a file of this name can be nothing else; empty: there is no such
    Likeness (*likeness)(const Json& document, std::string_view path) = nullptr;
    // A document whose format is known, as effects. Tolerant where the format's owner is, with a
    // remark, and strict where the owner refuses. What a reader takes as published and what it
    // guesses is at the head of its source file.
    Expected<Effects> (*read)(const Json& document, const EffectFile& file) = nullptr;
    bool (*is_xml)(std::string_view text) = nullptr;
    Expected<Effects> (*read_xml)(std::string_view text, const EffectFile& file) = nullptr;
    // What a file that is not read is known to be, from its name and its beginning, as the end of a
    // sentence; or empty.
    std::string (*stranger)(const std::filesystem::path& path, std::string_view head) = nullptr;
};

struct EffectsRead {
    const EffectFormat* format = nullptr;  // null: some other JSON or XML, and no effects
    ActuatorMap map;
    Effects effects;
    std::string about{};  // what the file says of itself: name, description, tags; or empty
};

}  // namespace tact
