// What people said of the set, from files.
#pragma once

#include <filesystem>

#include "app/document/workspace.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"
#include "model/io/people/ratings_file.h"

namespace tact {

void load_ratings_dialog(Ui& ui, const Workspace& work);

// The study of those patterns of the set that the loaded ratings are of.
Expected<RatingStudy> study_for(const PatternSet& set, const LoadedRatings& loaded);

// What was read of a file into the document, as one step; an error changes nothing.
void take_ratings(Ui& ui, Workspace& work, Layout& layout, const std::filesystem::path& path,
                  const LoadedRatings& loaded);

}  // namespace tact
