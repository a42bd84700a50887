// The picked subset as files: the set itself, a page about it, and its map.
//
//     subset.tactspace.json   the picked patterns, with what people said of them
//     subset.md               parameters, distances, what was proven
//     map.png, map.svg        the whole set, the picked ones bright
//
// Exact     same subset, same bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/subset/subset_state.h"
#include "app/ui/ui.h"
#include "model/map/mds.h"
#include "model/subset/subset.h"

namespace tact {

struct SubsetReport {
    const PatternSet& set;
    const Dissimilarity& dissimilarity;
    std::string quantity;  // "PM"
    SubsetObjective objective = SubsetObjective::max_min;
    const SubsetAnswer& answer;
    const PerceptualSpace& space;             // of the whole set ...
    std::string space_of = "PM";              // ... by this
    std::optional<double> weakest_of_best{};  // where `answer.best` is an alternative to it
    std::string origin{};  // "as a Joy-Con plays them, uncalibrated"; empty: as they are meant
};

// The page, Markdown.
std::string report_text(const SubsetReport& report);

// All files, each whole or not at all; makes the folder.
Expected<Done> write_subset(const std::filesystem::path& folder, const SubsetReport& report);

// From the window.
void export_subset_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking);
void export_subset(const ShownMap& shown_map, SubsetState& picking,
                   const std::filesystem::path& folder);

// Writes what is asked for: between two frames, as it draws pictures.
void continue_subset_export(Ui& ui, const ShownMap& shown_map, SubsetState& picking);

}  // namespace tact
