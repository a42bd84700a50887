// Files of other programs' effects, whichever of the formats it is: by content, not by name.
//
// formats.h says which formats there are.
//
// Output    patterns with curves and transients, not samples; several effects of a file are several
// Valid     files of at most kMostEffectBytes; errors as "FILE: PLACE: expected .."
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/io/effects/effect_format.h"

namespace tact {

inline constexpr std::size_t kMostEffectBytes = std::size_t{1} << 26;

// The format of a key; null if no format has it.
const EffectFormat* format_named(std::string_view key);

// The endings of files that can be nothing else: ".ahap", ".vibrate.json" ..
std::vector<std::string> effect_endings();
// Whether a file has such a name.
bool is_effect_name(std::string_view path);

// What a single effect of this file is called: its name without its ending.
std::string effect_stem(const std::filesystem::path& path);

// The beginning of a regular file that may be one of them, an object or numbers of JSON or XML;
// empty: it is something else, or too large.
std::string head_of_effects(const std::filesystem::path& path);
// The same of the first bytes of a file of this size.
std::string head_of_effects(std::string head, std::size_t size);

// What a file that holds no effect is known to be, as the end of a sentence, or empty: a fragment,
// or a format that was never published.
std::string known_stranger(const std::filesystem::path& path, std::string_view head);

// `path` for messages; its stem names the effects. Without a map each format has its own.
Expected<EffectsRead> read_effects(std::string_view text, const std::string& path,
                                   const std::optional<ActuatorMap>& map = {});

// The same, paid from a budget that other files are paid from as well.
Expected<EffectsRead> read_effects(std::string_view text, const std::string& path,
                                   const std::optional<ActuatorMap>& map, Budget& budget);

// "Buzz: a short alarm. Tags: alert, short. From buzz.ahap (AHAP). Actuator map core-haptics: Hz,
// gains ..": for the note of a pattern.
std::string origin_of(const EffectsRead& read, const Effect& effect, const std::string& file_name);

}  // namespace tact
