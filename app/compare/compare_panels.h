// The tabs that compare: metrics with people, the map with its distances, two patterns.
#pragma once

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_compare_panel(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                        Comparing& comparing);
void draw_shepard_panel(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing);
void draw_why_panel(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                    const ShownMap& shown_map, const Comparing& comparing);
// A table of all metrics, one of which can be chosen; with as many columns as fit into `area`.
void draw_metric_table(Ui& ui, Comparing& comparing, const Comparison& comparison,
                       const Rect& area);
// The Shepard diagram of the chosen metric, or of the ratings, in `area`; without the choice.
void draw_shepard_diagram(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                          const Rect& area);
ShepardFit shepard_fit(const FitRequest& request);  // sorts all pairs
void draw_compared_pairs(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                         Comparing& comparing, const Comparison& comparison);
// Rating against the chosen metric, one point per pair; needs ratings.
void draw_pairs_scatter(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                        const Comparison& comparison, const Rect& area);
void draw_findings(Ui& ui, Comparing& comparing, const Rect& area);

}  // namespace tact
