// What a command prints: text, JSON, CSV, with what is to be said of its numbers.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line/commands.h"
#include "app/pictures/pictures.h"
#include "app/rendering/rendering.h"
#include "devices/calibration/rendering.h"
#include "model/export/export_loss.h"
#include "model/set/pattern_set.h"
#include "model/subset/subset.h"

namespace tact {

// Where results, remarks and progress of a subcommand go.

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

// Tables for people at a terminal, and for programs.

using TextRow = std::vector<std::string>;

// Rows of equally many cells: the first column flush left, the others flush right, two blanks
// between. No blanks at the ends of lines.
std::string aligned(const std::vector<TextRow>& rows);

// "-0.11 to 0.78"; "-" for NaN.
std::string range_text(double low, double high, int digits);

// A line of CSV with its end, quoted where it has to be.
std::string csv_line(const TextRow& row);

// The shortest digits that read back as the same; nothing for NaN, which R and pandas read as
// missing.
std::string csv_number(double value);

// What an export costs, as a table for people: the numbers of model/export/loss_words.h.

// Tables of the patterns, of the set and of the pairs that moved most, and the verdict on the
// subset.
std::string text_of(const ExportLoss& loss);

}  // namespace tact
