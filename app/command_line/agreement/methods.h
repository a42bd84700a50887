// What the numbers of a table were made by: tests, sides, draws, seeds, what was resampled.
//
// Output    the line below a table; or a paragraph for a paper, with its references
// Exact     what is said here is what the parameters hold.
#pragma once

#include <span>
#include <string>

#include "app/command_line/agreement/set_agreement.h"

namespace tact {

// Lines below each of the tables of a set.
std::string foot_of_table(const SetAgreement& set);
std::string foot_of_uncertainty(const SetAgreement& set);
std::string foot_of_differences(const SetAgreement& set);
std::string foot_of_people(const SetAgreement& set);
std::string foot_of_given(const SetAgreement& set);
std::string foot_of_paper_table(const SetAgreement& set);

std::string methods_text(std::span<const SetAgreement> sets);

}  // namespace tact
