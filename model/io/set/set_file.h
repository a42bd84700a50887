// The set file, `.tactspace.json`: patterns, recordings, ratings and model parameters.
//
// Source    format 1: UTF-8 JSON; missing keys take defaults, unknown ones are kept on save.
// Output    errors as "FILE: PLACE: expected ..", PLACE a JSON pointer; syntax by line and column
// Valid     the limits of model/pattern/pattern.h and of model/text/json_fields.h; at most
//           kMaxSetSamples (load.h) in all recordings
//           Recordings may lie anywhere, as those of a set that was saved elsewhere do: the set
//           names them by "../" or in full. Outside of the set's folder only what is a regular file
//           of a recording's ending and parses as one is taken, and a message never quotes what is
//           in others: a set from somebody else cannot be used to look into them.
// Left out  the samples of recordings: the set names their files, by paths relative to its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/io/set/load.h"
#include "model/set/pattern_set.h"

namespace tact {

Expected<Loaded> read_set_file(const std::filesystem::path& path);

// A set from its text. Recordings are read from files relative to `folder`; in the set their paths
// are absolute.
Expected<PatternSet> parse_set(std::string_view text, const std::string& name_for_messages,
                               const std::filesystem::path& folder);

// The text of a set, with unchanged paths of recordings.
std::string print_set(const PatternSet& set);

// The same with paths relative to `folder`, as a set file in it has them.
std::string print_set(const PatternSet& set, const std::filesystem::path& folder);

// Replaces the file whole or not at all. The text is read again before it is written: a set that
// could not be opened (two equal names, a number out of range) is an Error, as the old file is
// worth more.
Expected<Done> write_set_file(const std::filesystem::path& path, const PatternSet& set);

// Numbers that tell whether a set is computed from what it was computed from before: what a person
// chose, not what arithmetic made of it.
//
// Left out  names, notes, colours: no number depends on them.

// Changes with any parameter of a pattern, any sample of a recording, and their order.
std::uint64_t vibrations_fingerprint(const PatternSet& set);

// Changes with any parameter of the model that is not at its default.
std::uint64_t model_fingerprint(const PatternSet& set);

}  // namespace tact
