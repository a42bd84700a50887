// The rows of the table of candidates: what it says of each pattern, and in which order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/candidates/candidates_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"

namespace tact {

// What a column of numbers says of a pattern; none: it has no such number, or the column no number.
std::optional<double> number_in(const CandidateRow& row, CandidateColumn column);

// The row closest to each row by PM; empty if there is only one.
NearestOnes nearest_ones(const std::shared_ptr<const LiveMap>& map);

// Those that the search finds, sorted; what a pattern has not comes last either way, and equal ones
// keep the order of the set.
const std::vector<CandidateRow>& candidate_rows(const Workspace& work, const ShownMap& shown_map,
                                                CandidatesState& state);

// All of it in CSV, a row for each with all digits.
std::string candidates_csv(const PatternSet& set, const std::vector<CandidateRow>& rows);

// The same column again turns the order round; numbers begin with the largest where that is what
// one looks for: how far the nearest is, and who is picked.
void sort_by(CandidatesState& state, CandidateColumn column);

}  // namespace tact
