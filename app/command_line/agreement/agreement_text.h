// Agreement with people as tables for people at a terminal, each with what it was made by.
//
// Exact     same input, same text.
#pragma once

#include <span>
#include <string>

#include "app/command_line/agreement/set_agreement.h"
#include "model/evaluation/evaluation.h"

namespace tact {

// Who was asked, and every table of one set. `is_paper`: rho and K alone, as Table 2 has them.
std::string agreement_text(const SetAgreement& set, bool is_paper);

// Means of one metric over sets, and the table of all.
MeanAgreement mean_of(std::span<const SetAgreement> sets, std::size_t metric, Bookkeeping books);
std::string means_text(std::span<const SetAgreement> sets, Bookkeeping books);

// How far anything could agree, each bound with what it bounds; sentences of their own lines.
std::string ceilings_text(const Ceilings& ceilings);

}  // namespace tact
