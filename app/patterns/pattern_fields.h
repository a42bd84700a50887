// The groups of fields that the editor of a pattern is made of.
#pragma once

#include <functional>
#include <string>

#include "app/document/workspace.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"

namespace tact {

// One gesture on one number: written to all selected patterns, an undo step when it ends. `what` is
// its name in the step's label.
void edit_number(Ui& ui, Workspace& work, const Field& field, double value, const std::string& what,
                 const std::function<void(Pattern&, double)>& write);

// Carriers, their mix or weights, and the warning of leakage.
void draw_carrier_fields(Ui& ui, Workspace& work, const Pattern& pattern);

// The rhythm as text and as a grid to click on.
void draw_rhythm_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                        const Pattern& pattern);

}  // namespace tact
