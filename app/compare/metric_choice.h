// Choosing a metric, and what is known of the comparison of all: shared by the tabs that show one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// "Msm: spectral matching, ... Park & Kuchenbecker 2019.": what its short name stands for.
std::string metric_help(Metric metric);

// Those of the program, then one's own.
struct NamedMetric {
    std::string key;
    std::string name;
    std::string help;
};
std::vector<NamedMetric> named_metrics(const Comparing& comparing);

// A list to choose from; `with_people`: the ratings' own map too.
void draw_metric_choice(Ui& ui, const Workspace& work, Comparing& comparing, bool with_people);

// Progress, Cancel, or why there is no comparison; true where there is one to draw, perhaps of an
// earlier state.
bool draw_comparison_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           Comparing& comparing);

// The pair that is chosen, as a scatter of `vibrations` has it: none where the open set has others.
std::optional<std::size_t> scatter_selection(const Workspace& work, const ShownMap& shown_map,
                                             const std::vector<Vibration>& vibrations);

// Chooses the pair that was clicked there.
void choose_clicked(Workspace& work, const std::vector<Vibration>& vibrations,
                    std::optional<std::size_t> clicked);

}  // namespace tact
