// Keeping the comparison with people, and of the chosen pair, in step with the map on screen.
#pragma once

#include <optional>
#include <utility>

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

// The current pattern and the one it is held against.
enum class PartnerKind { chosen, pinned, closest };
struct ChosenPair {
    std::size_t current = 0;
    std::size_t partner = 0;
    PartnerKind kind = PartnerKind::chosen;
};

// Chosen by a click, else pinned, else the closest by PM. None with fewer than two patterns.
std::optional<ChosenPair> chosen_pair(const App& app);

// Their rows in the map on screen, which there must be; none where it leaves one of them out.
std::optional<std::pair<std::size_t, std::size_t>> rows_in_map(const App& app,
                                                               const ChosenPair& pair);

// Makes the first pattern current and the second its partner.
void choose_pair(App& app, std::size_t current, std::size_t partner);

// The map of the ratings, laid over the one on screen: one row a pattern of the shown map. None
// without ratings of its patterns, or while their comparison is under way.
std::optional<Eigen::MatrixXd> people_over_map(const App& app);

// Ratings into the document, as one step; an error changes nothing.
void load_ratings_dialog(App& app);
void load_ratings(App& app, const std::vector<std::filesystem::path>& paths);

// What was dropped on the window: tables of ratings or of accelerations go to the open set, all
// else is opened.
void drop_paths(App& app, const std::vector<std::filesystem::path>& paths);

}  // namespace tact
