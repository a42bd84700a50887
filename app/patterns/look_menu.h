// The part of a row's menu that changes colour and mark.
#pragma once

#include <cstddef>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Of all that is selected, one step; `index` shows what it is now.
void draw_look_menu(Ui& ui, Workspace& work, std::size_t index);

}  // namespace tact
