// Parts that the files of this room share.
#pragma once

#include <string>

#include "app/ui/widgets.h"

namespace tact {

inline constexpr double kCoarse = 5.0;  // steps of a number with Shift
inline constexpr double kFine = 0.1;    // and with Alt

// The entry is the last ImGui item afterwards.
NumberEdit edit_entry(Ui& ui, const NumberEntry& entry, double& value);

// Steps of the wheel over the last item; it scrolls nothing then.
int wheel_steps(Ui& ui);

// Merges the undo step of this frame with the last one, if that was a moment ago and by the same
// keys.
void join_steps(Ui& ui, const std::string& field);

// Whether the last item is disabled.
bool is_item_disabled();

}  // namespace tact
