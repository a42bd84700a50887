// Shown in place of map, answers and editor while the set is empty: a few examples, and other ways
// to begin.
#pragma once

#include <filesystem>
#include <optional>

#include "app/document/workspace.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"

namespace tact {

// Returns what was pressed, for the frame; an example is added here.
struct StartAction {
    enum class Way { open, generate, recent } way;
    std::filesystem::path file{};  // path of a recent file
};

std::optional<StartAction> draw_start_page(Ui& ui, Workspace& work, StartPage& page);

}  // namespace tact
