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
    bool stale = false;   // of an earlier value of the pattern
    bool pinned = false;  // the one for comparison
};

struct StageSize {
    bool large = false;                // fills the pane: values, units, all channels
    bool time_axis = false;            // ticks below
    std::optional<ImVec2> controls{};  // where those of a large stage begin; none: it has none
    bool names = true;                 // of lanes, beside them: not in thumbnails
    float lanes_px = 0.0F;  // right of the area, for the names of lanes; 0: there are none
};

// What names of lanes take: as much as they need, or only their marks where that is much.
float lane_names_px(const Ui& ui, float width_px);

// A receptor's mark and, where it fits, its name: in the middle of a place beside its lane.
void draw_lane_name(const Ui& ui, const Rect& place, Receptor receptor);

// How many g the upper edge of a stage's plots is, "±1.6 g"; empty: it is not in g.
std::string reach_text(const Workspace& work, const ShownStages& shown, Stage stage);

void draw_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                const ShownStages& shown, Stage stage, const Rect& area, const StageSize& size);

// Signals of the first pattern minus those of the second; the relative difference where a stage has
// no signals.
void draw_stage_difference(Ui& ui, const Workspace& work, Timeline& timeline,
                           const Physiology& physiology, const ShownStages& a, const ShownStages& b,
                           Stage stage, const Rect& area, const StageSize& size);

// Of what two patterns do not share: neither a receptor's colour nor a pattern's.
ImU32 difference_colour(const Theme& theme);

// The channel with the strongest activity at the centre: what the overview shows the networks of.
Receptor strongest_channel(const LiveStages& live);

}  // namespace tact
