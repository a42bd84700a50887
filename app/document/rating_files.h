// What people said of the set, from files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/app.h"

namespace tact {

// Ratings into the document, as one step; an error changes nothing.
void load_ratings_dialog(App& app);
void load_ratings(App& app, const std::vector<std::filesystem::path>& paths);

}  // namespace tact
