// The numbers of the chosen point or transient, typed and nudged as every other.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

inline constexpr const char* kChosenValue = "chosen_value";

void draw_chosen_fields(Ui& ui, Workspace& work, const StripState& strip);

}  // namespace tact
