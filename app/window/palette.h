// The command palette: what was typed in it.
#pragma once

#include <string>

namespace tact {

struct PaletteState {
    bool open = false;
    std::string text;
    int choice = 0;
};

}  // namespace tact
