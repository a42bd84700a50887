// Where results, remarks and progress of a subcommand go.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line/commands.h"
#include "app/pictures/pictures.h"
#include "app/rendering/labels.h"
#include "devices/calibration/rendering.h"
#include "model/set/named_place.h"
#include "model/set/pattern_set.h"
#include "model/subset/subset.h"

namespace tact {

// The sets of a command as one, or the side of it asked for: as it was meant, and as it comes back
// from the files, and is played by the device, that the options name; the same where they name
// none. Remarks go to standard error.
struct FeltSet {
    PatternSet meant;
    PatternSet felt;
    Labels labels;
};
Expected<FeltSet> load_felt(const CommonOptions& options);

// One of the two alone; the device and the files, if any.
Expected<PatternSet> load_for(const CommonOptions& options);
Expected<PatternSet> load_as_meant(const CommonOptions& options);
Expected<std::optional<RenderedBy>> rendered_by(const CommonOptions& options);
Expected<std::optional<ExportTarget>> exported_as(const CommonOptions& options);

// An Error unless the set has at least two patterns: fewer make no matrix and no map.
Expected<Done> need_a_pair(const PatternSet& set, const CommonOptions& options);

// "A,B": two different patterns, at the comma that parts two names, as a name may have one of its
// own. `option` begins what an Error says.
struct NamedPair {
    std::size_t a = 0;
    std::size_t b = 0;
};
Expected<NamedPair> pair_of(const PatternSet& set, const std::string& option,
                            const std::string& text);

// Why nothing can be picked, and how many were left out as nobody feels them.
Error unpickable(const Error& fault, std::size_t left_out);

// What the ending of a picture's name asks for: .png or .svg; none is PNG. An Error also if the
// file cannot be written.
Expected<PictureFormat> picture_format(const std::filesystem::path& file);

// An Error if a result cannot be written there: better known before the work than after it. Pipes
// and devices are left alone.
Expected<Done> writable_result(const std::filesystem::path& out);

// Calls `write` on the file, which appears whole or not at all, or on standard output where the
// path is empty.
Expected<Done> write_result(const std::filesystem::path& out,
                            const std::function<void(std::ostream&)>& write);

// A progress function with the time left: for a person at a terminal one line that rewrites itself,
// for a log a line every minute. `said`: what the line ends with, when it is shown.
std::function<void(double)> progress_line(const std::string& what);
std::function<void(double)> progress_line_with(const std::string& what,
                                               std::function<std::string()> said);

// The same for a search of a subset: with what was found so far, and what no subset exceeds.
void tell_search(SubsetOptions& options, const std::string& what, SubsetObjective objective);

}  // namespace tact
