// Helpers shared by the pictures of receptors and of their spikes.
#pragma once

#include <string>
#include <vector>

#include "app/stages/stage_views.h"

namespace tact {

// Name of a picture for tests and for ImGui; that of the compared pattern differs.
std::string id_of(const ShownStages& shown, const std::string& name);

// The model step under the playhead.
std::size_t step_at(const Timeline& timeline, const ShownStages& shown);

int total_spikes(const std::vector<int>& train);

// Everything about one receptor, within `bounds`.
void draw_receptor_readout(Ui& ui, const Timeline& timeline, const ShownStages& shown,
                           const ReceptorPlace& place, const Rect& bounds, ImVec2 at);

}  // namespace tact
