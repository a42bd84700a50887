// The groups of fields that the editor of a pattern is made of.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/pattern/pattern_parameter.h"

namespace tact {

// A number of a pattern; none where it has no such number, as a third carrier.
using ReadNumber = std::function<std::optional<double>(const Pattern&)>;
using WriteNumber = std::function<void(Pattern&, double)>;

// One gesture on one number: of all selected patterns, an undo step when it ends. Where they
// differ, what is typed becomes that of all; dragged they keep their proportions, or their
// differences where one is not above 0. `what` is its name in the step's label.
void edit_number(Ui& ui, Workspace& work, Field field, const std::string& what,
                 const ReadNumber& read, const WriteNumber& write);

// What a number's table says in seconds, for a field in milliseconds.
inline Range in_ms(const Range& seconds) { return {1000.0 * seconds.low, 1000.0 * seconds.high}; }

// A tooltip of what can be pressed among the fields, or why it cannot.
void draw_field_tooltip(const Ui& ui, const char* text);

// The nearest step above 0; of no steps, the value itself.
double snapped_to(double value, double snap);

// One more carrier at three times the last one's frequency, 500 Hz at most, if there is room; all
// get equal shares, so that the pattern does not get stronger by it.
void push_carrier(Pattern& pattern);

// Carriers, their mix or weights, and the warning of leakage.
void draw_carrier_fields(Ui& ui, Workspace& work, const Pattern& pattern);

// The rhythm as text and as a grid to click on.
void draw_rhythm_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                        const Pattern& pattern);

}  // namespace tact
