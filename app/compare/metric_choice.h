// Choosing a metric, and the state of the comparison: shared by the tabs that show one metric.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// "Msm: spectral matching, ... Park & Kuchenbecker 2019.": the explanation of its short name.
std::string metric_help(Metric metric);

// Metrics of the program, then foreign ones.
struct NamedMetric {
    std::string key;
    std::string name;
    std::string help;
};
std::vector<NamedMetric> named_metrics(const Comparing& comparing);

// A list of metrics to choose from; `with_people`: also the ratings' own map.
void draw_metric_choice(Ui& ui, const Workspace& work, Comparing& comparing, bool with_people);

// Progress, Cancel, or the reason why there is no comparison. True if there is one to draw, perhaps
// of an earlier state.
bool draw_comparison_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           Comparing& comparing);

// The chosen pair as two indices into `vibrations`; nullopt if the open set has other patterns.
std::optional<std::size_t> scatter_selection(const Workspace& work, const ShownMap& shown_map,
                                             const std::vector<Vibration>& vibrations);

// Chooses the clicked pair.
void choose_clicked(Workspace& work, const std::vector<Vibration>& vibrations,
                    std::optional<std::size_t> clicked);

}  // namespace tact
