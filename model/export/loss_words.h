// What an export costs, in words and short numbers: the same on the terminal, in the window and on
// the page.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

#include "model/export/export_loss.h"

namespace tact {

// "12.5" of PM, g or stress; four digits that count, and 0 below a millionth.
std::string loss_number(double value);

// "41.3"; "-" where nothing is lost, or nothing was meant.
std::string psnr_text(const PatternLoss& loss);

// PM from what was meant; "-" of a set of one.
std::string moved_text(const PatternLoss& loss);

// "a and b".
std::string pair_text(const ExportLoss& loss, std::size_t a, std::size_t b);

// "closest pair": "3.5, a and b" before, "1, a and c" after.
struct BeforeAfter {
    std::string what;
    std::string before;
    std::string after;

    bool operator==(const BeforeAfter&) const = default;
};

// Closest pair, weakest pair of the picked subset, stress of the maps: what there is of them.
std::vector<BeforeAfter> before_after_rows(const ExportLoss& loss);

// Names of some patterns: "a, b, c".
std::string names_text(const ExportLoss& loss, const std::vector<std::size_t>& members);

// Whether the proven subset is still the best, and what would be; or why nothing can be said. A
// sentence without its stop.
std::string subset_verdict(const ExportLoss& loss);

// "9 of 12 patterns lose something; 2 are farther from what was meant than the closest pair is
// apart": the first thing to know. It counts the patterns at the places `written`.
std::string summary_of(const ExportLoss& loss, std::span<const std::size_t> written);
std::string summary_of(const ExportLoss& loss);  // of all that can be written

// The places of all patterns: those that are written come first, in their order.
std::vector<std::size_t> written_first(const ExportLoss& loss,
                                       std::span<const std::size_t> written);

// What PM after the export means: a sentence for the foot of each table.
inline constexpr const char* kAfterScale =
    "PM after is on the scale of the set as it was meant: where its pairs would stand among those";

// What an export costs as a document: of the command export and of Python.

// {"labels", "patterns": [{"pattern", "rms_error_g", "psnr_db", "moved", "remarks"}], "before",
// "after" (condensed PM), "closest", "most_moved", "subset", "map"}; null if missing.
nlohmann::json json_of(const ExportLoss& loss);

}  // namespace tact
