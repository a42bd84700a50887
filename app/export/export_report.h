// The page beside exported files: what the export costs in perception, for who gets them.
//
// Exact     same loss, same bytes.
#pragma once

#include <string>
#include <vector>

#include "model/export/export_loss.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ExportPage {
    const ExportLoss& loss;
    const PatternSet& set;                    // that was predicted
    const std::vector<std::size_t>& written;  // of its patterns ...
    const std::vector<std::string>& files;    // ... as these
};

std::string export_report(const ExportPage& page);

}  // namespace tact
