// How a metric agrees with people as a document: one set of keys for the command compare, for study
// and for Python.
//
// Output    NaN where a number is not defined, which becomes null as text
// Exact     same input, same document.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "model/evaluation/metric_comparison.h"
#include "model/study/agreement.h"

namespace tact {

// The table of one set. Only the rated patterns are in the numbers.
struct RatedTable {
    const RatedPeople& people;
    const InterRater& raters;
    const MetricTable& table;
};

// All numbers of the metric at this place of the table: rho with its interval (rho_low, rho_high
// are those of rho_resampled over patterns), K, how far people agree, ceilings, differences from PM
// (pm_less_this) and what is left of rho where something else is given.
nlohmann::json json_of(const RatedTable& rated, std::size_t metric, Bookkeeping books);

// icc_single, icc_mean, alpha, with _low and _high and the pairs that they are of.
void add_to(nlohmann::json& json, const InterRater& raters);

}  // namespace tact
