// The parts that the table is drawn from. Private to the room.
#pragma once

#include <vector>

#include "app/candidates/candidates.h"
#include "viz/drawing/geometry.h"

namespace tact {

// A line of headings, which sort when they are pressed.
void draw_headings(Ui& ui, CandidatesState& state, const std::vector<ColumnSpan>& places);

// What a column says of one pattern.
void draw_cell(Ui& ui, Workspace& work, const CandidateRow& row, CandidateColumn column,
               const Rect& cell);

}  // namespace tact
