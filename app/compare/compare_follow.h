// Keeping the comparison with people, and of the chosen pair, in step with the map on screen.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/map/pair.h"
#include "app/rendering/rendering_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

void make_compare_jobs(const Ui& ui, RenderingState& rendered, Comparing& comparing);

// Takes what the jobs have finished; asks for what the open tab shows and has not yet.
void take_compare_answers(RenderingState& rendered, Comparing& comparing);
void follow_comparing(const Workspace& work, const Layout& layout, const ShownMap& shown_map,
                      RenderingState& rendered, Comparing& comparing);

// The comparison of the map on screen; of an earlier one: is_stale.
struct ShownComparison {
    std::shared_ptr<const Comparison> comparison;  // null: none yet
    bool is_stale = false;
    bool is_computing = false;
};
ShownComparison shown_comparison(const Workspace& work, const ShownMap& shown_map,
                                 const Comparing& comparing);

// A comparison of this many patterns waits for a word of the person, or was cancelled by them.
bool comparison_waits(const Workspace& work, const Comparing& comparing);
void ask_for_comparison(const Workspace& work, Comparing& comparing);
void cancel_comparison(const Workspace& work, Comparing& comparing);

// Metrics of one's own: a matrix in a file, or a function in Python, of which it may have several.
void add_metric_dialog(Ui& ui, const Workspace& work);
void add_metric(Ui& ui, Comparing& comparing, const std::filesystem::path& file);
void remove_metric(Comparing& comparing, const std::string& key);

// The map of the ratings, laid over the one on screen: one row a pattern of the shown map, NaN for
// those that nobody rated. None without ratings of its patterns, or while their comparison is under
// way.
std::optional<Eigen::MatrixXd> people_over_map(const ShownMap& shown_map,
                                               const Comparing& comparing);
std::string people_over_map_text(const Comparing& comparing);  // whose it is

}  // namespace tact
