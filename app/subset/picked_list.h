// The members of the subset on screen: their rows, and the keys that play them.
#pragma once

#include <cstddef>
#include <string>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/patterns/pattern_menu.h"
#include "app/play/play_state.h"
#include "app/subset/subset_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

inline constexpr std::size_t kPlayKeys = 9;  // 1 to 9

// A row in a list of that width: with a picture of the waveform where there is room for one.
float member_row_px(const Ui& ui, float width_px);

// Draws the pattern of that name, the `number`-th from 1 on. Its menu is that of every pattern.
PatternAction draw_member(Ui& ui, Workspace& work, const std::string& name, std::size_t number);

// Plays once the `number`-th of the subset on screen, from 1 on; says so if it is missing.
void play_picked(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                 PlayState& play, const SubsetState& picking, std::size_t number);

}  // namespace tact
