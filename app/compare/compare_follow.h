// Updates the comparison with people, and that of the chosen pair, when the map on screen changes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/map/pair.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

// Collects finished jobs, and starts those that the open tab needs.
void take_compare_answers(Comparing& comparing);
void follow_comparing(const Ui& ui, const Workspace& work, const Layout& layout,
                      const ShownMap& shown_map, Comparing& comparing);

// The paper's findings, checked on its own sets.
void ask_for_findings(const Ui& ui, Comparing& comparing);

// The newest comparison; `is_stale`: it belongs to an earlier map.
struct ShownComparison {
    std::shared_ptr<const Comparison> comparison;  // null: no comparison yet
    bool is_stale = false;
    bool is_computing = false;
};
ShownComparison shown_comparison(const Workspace& work, const ShownMap& shown_map,
                                 const Comparing& comparing);

// A comparison of this many patterns waits until the person asks for it, or the person cancelled
// it.
bool comparison_waits(const Workspace& work, const Comparing& comparing);
void ask_for_comparison(const Workspace& work, Comparing& comparing);
void cancel_comparison(const Workspace& work, Comparing& comparing);

// Foreign metrics: a matrix in a file, or a Python function; one file may hold several.
void add_metric_dialog(Ui& ui, const Workspace& work);
void add_metric(Ui& ui, Comparing& comparing, const std::filesystem::path& file);
void remove_metric(Comparing& comparing, const std::string& key);

// The map of the ratings, aligned to the one on screen: one row per pattern of the shown map, NaN
// for unrated patterns. Nullopt without ratings of its patterns, or while they are being compared.
std::optional<Eigen::MatrixXd> people_over_map(const ShownMap& shown_map,
                                               const Comparing& comparing);
std::string people_over_map_text(const Comparing& comparing);  // the raters

}  // namespace tact
