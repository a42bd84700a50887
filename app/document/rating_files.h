// What people said of the set, from files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

// Ratings into the document, as one step; an error changes nothing.
void load_ratings_dialog(Ui& ui, const Workspace& work);
void load_ratings(Ui& ui, Workspace& work, Layout& layout,
                  const std::vector<std::filesystem::path>& paths);

}  // namespace tact
