// Parts that the files of this room share.
#pragma once

#include <string>
#include <vector>

#include "model/evaluation/individuals.h"
#include "model/planning/preregistration.h"

namespace tact {

// A page that says what a study is to show before anybody is asked, to be deposited as it is.
//
// Input     the plan; nothing here decides
// Output    one HTML page that stands alone
// Exact     same input, same bytes.

std::string preregistration_page(const Preregistration& plan);

// A section for a study's page: what was planned, what was done. Empty of nothing.
std::string planned_section(const std::string& planned_on,
                            const std::vector<PlannedAndDone>& lines);

// Star plots of what each participant goes by: a ray a dimension of the common map, as long as its
// weight, and of all of them on average as a dashed line.

// A section of a page; empty where nobody has weights.
std::string weights_section(const IndividualWeights& weights);

// Its CSS.
std::string weights_style();

}  // namespace tact
