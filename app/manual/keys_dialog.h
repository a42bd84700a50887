// The list of keys and of what the mouse does: groups in columns, and a search.
#pragma once

#include <span>
#include <string>

#include "app/manual/manual_state.h"
#include "app/ui/ui.h"

namespace tact {

struct KeyRow {
    std::string group;  // "Edit", "Map"
    std::string keys;
    std::string what;  // of a command the way through the menus, which may begin with the group
};

void draw_keys_dialog(Ui& ui, ManualState& manual, std::span<const KeyRow> rows);

}  // namespace tact
