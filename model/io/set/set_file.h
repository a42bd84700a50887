// The set file, `.tactspace.json`: patterns, recordings, ratings and model parameters.
//
// Source    format 1: UTF-8 JSON; missing keys take defaults, unknown ones are kept on save.
// Output    errors as "FILE: PLACE: expected ..", PLACE a JSON pointer; syntax by line and column
// Valid     the limits of model/pattern/pattern.h; a file of at most 1 GiB
// Left out  the samples of recordings: the set names their files, by paths relative to its own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/io/set/loaded.h"

namespace tact {

Expected<Loaded> read_set_file(const std::filesystem::path& path);

// A set from its text. Recordings are read from files relative to `folder`; in the set their paths
// are absolute.
Expected<PatternSet> parse_set(std::string_view text, const std::string& name_for_messages,
                               const std::filesystem::path& folder);

// The text of a set, with the paths of recordings as they are.
std::string print_set(const PatternSet& set);

// The same with paths relative to `folder`, as a set file in it has them.
std::string print_set(const PatternSet& set, const std::filesystem::path& folder);

// Replaces the file whole or not at all. A set that could not be read again (two equal names, a
// number out of range) is an Error: the old file is worth more.
Expected<Done> write_set_file(const std::filesystem::path& path, const PatternSet& set);

}  // namespace tact
