// The picked subset as files: the set itself, a page about it, and its map; or the page alone.
//
//     subset.tactspace.json   the picked patterns, with what people said of them
//     report.html             what feels the same, what was proven (app/report)
//     map.png, map.svg        the whole set, the picked ones bright
//
// Exact     same subset, same bytes.
#pragma once

#include <filesystem>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/report/report.h"
#include "app/subset/subset_state.h"
#include "app/ui/ui.h"

namespace tact {

// All files, each whole or not at all; makes the folder.
Expected<Done> write_subset(const std::filesystem::path& folder, const Report& report);

// From the window. Both wait until an exact subset of the set as it is has been picked.
void export_subset_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking);
void export_subset(Ui& ui, SubsetState& picking, const std::filesystem::path& folder);

void export_report_dialog(Ui& ui, const Workspace& work);
void export_report(Ui& ui, SubsetState& picking, const std::filesystem::path& file);

// Writes what is asked for: between two frames, as it draws pictures.
void continue_subset_export(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                            SubsetState& picking);

}  // namespace tact
