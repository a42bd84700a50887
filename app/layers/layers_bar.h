// The layers of the pattern in the editor, a row each: which is open, what is heard of each, how
// strong, from when on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

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
