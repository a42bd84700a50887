// The groups of fields that the editor of a pattern is made of.
#pragma once

#include <functional>
#include <string>

#include "app/ui/widgets.h"
#include "app/window/app.h"

namespace tact {

// One gesture on one number: written to all selected patterns, an undo step when it ends. `what` is
// its name in the step's label.
void edit_number(App& app, const Field& field, double value, const std::string& what,
                 const std::function<void(Pattern&, double)>& write);

// Carriers, their mix or weights, and the warning of leakage.
void draw_carrier_fields(App& app, const Pattern& pattern);

// The rhythm as text and as a grid to click on.
void draw_rhythm_fields(App& app, const Pattern& pattern);

}  // namespace tact
