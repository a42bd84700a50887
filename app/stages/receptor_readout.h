// What pictures of receptors and of their spikes have in common.
#pragma once

#include <string>
#include <vector>

#include "app/stages/stage_views.h"

namespace tact {

// A picture's name for tests and for ImGui: the one for comparison is another.
std::string id_of(const ShownStages& shown, const std::string& name);

// The step of the model that the playhead is in.
std::size_t step_at(const Timeline& timeline, const ShownStages& shown);

int total_spikes(const std::vector<int>& train);

// Everything about one receptor, within `bounds`.
void draw_receptor_readout(Ui& ui, const Timeline& timeline, const ShownStages& shown,
                           const ReceptorPlace& place, const Rect& bounds, ImVec2 at);

}  // namespace tact
