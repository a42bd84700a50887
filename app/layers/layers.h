// Bed, notes, ticks and recordings of one pattern, one open at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Edits of the layers of the pattern in the editor.

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

// The layers of the pattern in the editor, a row each: which is open, what is heard of each, how
// strong, from when on.

struct LayersBar {
    // The open layer's row alone; none: where all rows would leave too little for the drawing.
    std::optional<bool> is_folded;
    std::optional<std::size_t> renaming;
    std::string renaming_of;  // name of the pattern
    std::string name;         // as it is typed
    bool is_typing = false;
};

// Nothing of a pattern without layers. `room_px`: the height that it shares with the drawing.
void draw_layers_bar(Ui& ui, Workspace& work, LayersBar& bar, float room_px);

// The button that adds one, where there is room for one more.
void draw_add_layer(Ui& ui, Workspace& work);

}  // namespace tact
