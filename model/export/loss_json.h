// What an export costs as a document: of the command export and of Python.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/export/export_loss.h"

namespace tact {

// {"labels", "patterns": [{"pattern", "rms_error_g", "psnr_db", "moved", "remarks"}], "before",
// "after" (condensed PM), "closest", "most_moved", "subset", "map"}; null if missing.
nlohmann::json json_of(const ExportLoss& loss);

}  // namespace tact
