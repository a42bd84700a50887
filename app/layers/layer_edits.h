// Edits of the layers of the pattern in the editor.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Changes a layer of the current vibration, if that is not locked; the step is yet to be committed.
void edit_layer(Workspace& work, std::size_t k, const std::function<void(Layer&)>& change);

// As much of a name as a file may hold.
std::string cut_name(const std::string& name);

// One step each. A pattern without layers becomes the first of two; a single layer that is left as
// it was by itself is a pattern again.
void add_layer(Ui& ui, Workspace& work);
void remove_layer(Ui& ui, Workspace& work, std::size_t k);

// The selected vibrations as the layers of one, behind them; and each layer as a pattern by itself.
bool can_be_layered(const Workspace& work);
void layer_selected(Ui& ui, Workspace& work);
void split_layers(Ui& ui, Workspace& work);

}  // namespace tact
