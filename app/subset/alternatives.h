// Subsets beside the best one: which are as good, or nearly.
#pragma once

#include <cstddef>
#include <string>

#include "app/subset/subset_state.h"
#include "app/ui/ui.h"

namespace tact {

// Name of a pattern when it was picked.
const std::string& name_of(const Pick& pick, std::size_t member);

// Which pattern replaces which in each. A click shows it in the place of the best.
void draw_alternatives(Ui& ui, SubsetState& picking, const Pick& pick);
// How high they are at such a width.
float alternatives_px(const Ui& ui, const SubsetState& picking, const Pick& pick, float width_px);

}  // namespace tact
