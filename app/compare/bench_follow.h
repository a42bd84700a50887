// Keeping the comparison with people, and of the chosen pair, in step with the map on screen.
#pragma once

#include <optional>
#include <utility>

#include "app/map/pair.h"
#include "app/window/app.h"

namespace tact {

void make_bench_jobs(App& app);

// Takes what the jobs have finished; asks for what the open tab shows and has not yet.
void take_bench_answers(App& app);
void follow_bench(App& app);

// The comparison of the map on screen; of an earlier one: is_stale.
struct ShownComparison {
    std::shared_ptr<const Comparison> comparison;  // null: none yet
    bool is_stale = false;
    bool is_computing = false;
};
ShownComparison shown_comparison(const App& app);

// A comparison of this many patterns waits for a word of the person, or was cancelled by them.
bool comparison_waits(const App& app);
void ask_for_comparison(App& app);
void cancel_comparison(App& app);

// The map of the ratings, laid over the one on screen: one row a pattern of the shown map. None
// without ratings of its patterns, or while their comparison is under way.
std::optional<Eigen::MatrixXd> people_over_map(const App& app);

}  // namespace tact
