// What an export costs, as a table for people and as JSON: the same numbers in both.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/export/export_loss.h"

namespace tact {

// Tables of the patterns, of the set and of the pairs that moved most, and the verdict on the
// subset.
std::string text_of(const ExportLoss& loss);

// {"labels", "patterns": [{"pattern", "rms_error_g", "psnr_db", "moved", "remarks"}], "before",
// "after" (condensed PM), "closest", "most_moved", "subset", "map"}; null if missing.
nlohmann::json json_of(const ExportLoss& loss);

}  // namespace tact
