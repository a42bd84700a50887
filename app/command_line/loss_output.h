// What an export costs, as a table for people: the numbers of model/export/loss_json.h.
#pragma once

#include <string>

#include "model/export/export_loss.h"

namespace tact {

// Tables of the patterns, of the set and of the pairs that moved most, and the verdict on the
// subset.
std::string text_of(const ExportLoss& loss);

}  // namespace tact
