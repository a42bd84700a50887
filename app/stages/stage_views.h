// One stage of one pattern, small among the others or filling the pane.
#pragma once

#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// A pattern whose stages are shown.
struct ShownStages {
    std::shared_ptr<const LiveStages> live;
    PatternLook look;
    bool stale = false;   // belongs to an earlier version of the pattern
    bool pinned = false;  // the pattern for comparison
};

struct StageSize {
    bool large = false;                // fills the pane: values, units, all channels
    bool time_axis = false;            // ticks below the plots
    std::optional<ImVec2> controls{};  // place of a large stage's controls; nullopt: no controls
    bool names = true;                 // names of lanes, beside them; false in thumbnails
    float lanes_px = 0.0F;  // room for the names of lanes, right of the area; 0: no lanes
};

// Width for the names of lanes: as much as they need, or only their marks if that is too much.
float lane_names_px(const Ui& ui, float width_px);

// A receptor's mark and, if it fits, its name: in the middle of a place beside its lane.
void draw_lane_name(const Ui& ui, const Rect& place, Receptor receptor);

// The upper edge of a stage's plots, "±1.6 g"; empty if the stage has no g.
std::string reach_text(const Workspace& work, const ShownStages& shown, Stage stage);

void draw_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                const ShownStages& shown, Stage stage, const Rect& area, const StageSize& size);

// Signals of the first pattern minus those of the second; for stages without signals, the relative
// difference.
void draw_stage_difference(Ui& ui, const Workspace& work, Timeline& timeline,
                           const Physiology& physiology, const ShownStages& a, const ShownStages& b,
                           Stage stage, const Rect& area, const StageSize& size);

// The colour of differences, neither a receptor's nor a pattern's.
ImU32 difference_colour(const Theme& theme);

// The channel with the strongest activity at the centre: the overview shows its networks.
Receptor strongest_channel(const LiveStages& live);

}  // namespace tact
