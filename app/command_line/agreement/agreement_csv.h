// Agreement with people as tidy tables for R and Python: a row an observation, nothing for what is
// not defined, and on every row whose the numbers are.
//
// Exact     same input, same bytes.
#pragma once

#include <iosfwd>
#include <span>

#include "app/command_line/agreement/set_agreement.h"

namespace tact {

// A row a metric.
void write_metrics_csv(std::ostream& stream, std::span<const SetAgreement> sets);

// A row a participant and metric.
void write_people_csv(std::ostream& stream, std::span<const SetAgreement> sets);

// A row a metric that PM is compared with, and a way to resample.
void write_differences_csv(std::ostream& stream, std::span<const SetAgreement> sets);

}  // namespace tact
