// The set as a table: a row a pattern, its numbers side by side, sorted by any of them.
#pragma once

#include "app/candidates/candidates_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/patterns/pattern_menu.h"
#include "app/ui/ui.h"

namespace tact {

// A click selects as in the list, through the order of the table; what is selected is locked and
// dropped together.
PatternAction draw_candidates_panel(Ui& ui, Workspace& work, const ShownMap& shown_map,
                                    CandidatesState& state);

// Which columns a table of this width has, and where each begins and ends. The picture takes what
// is left over; in a narrow table the duration goes first, then it, the rhythm, the modulation.
// `nearest_px`: what the largest PM takes, at a scale of 1; it has that where the table has room.
struct ColumnSpan {
    CandidateColumn column;
    float begin_px = 0.0F;
    float end_px = 0.0F;
};
std::vector<ColumnSpan> column_places(float width_px, float scale, float nearest_px = 0.0F);

}  // namespace tact
