// A page that says what a study is to show before anybody is asked, to be deposited as it is.
//
// Input     the plan; nothing here decides
// Output    one HTML page that stands alone (html.h)
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "model/planning/preregistration.h"

namespace tact {

std::string preregistration_page(const Preregistration& plan);

// A section for a study's page: what was planned, what was done. Empty of nothing.
std::string planned_section(const std::string& planned_on,
                            const std::vector<PlannedAndDone>& lines);

}  // namespace tact
