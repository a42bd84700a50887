// Parts that the files of this room share.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/physiology/physiology.h"
#include "app/stages/stages.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/charts/spectrum_view.h"
#include "viz/drawing/geometry.h"

namespace tact {

// One stage of one pattern, small among the others or filling the pane.

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

// Helpers shared by the pictures of receptors and of their spikes.

// Name of a picture for tests and for ImGui; that of the compared pattern differs.
std::string id_of(const ShownStages& shown, const std::string& name);

// The model step under the playhead.
std::size_t step_at(const Timeline& timeline, const ShownStages& shown);

int total_spikes(const std::vector<int>& train);

// Everything about one receptor, within `bounds`.
void draw_receptor_readout(Ui& ui, const Timeline& timeline, const ShownStages& shown,
                           const ReceptorPlace& place, const Rect& bounds, ImVec2 at);

// Text beside a stage's plots.

// Name and quantity, left of the plots; the name opens the stage, the "i" explains it.
// Returns the lower end.
float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area);

// Largest value up and down, at the bottom of the label if there is room.
void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text);

// All stages below one another.

// Stages of one pattern or two; scrolls if the pane is too low.
void draw_overview(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns);

// A stage of one pattern, or of two with their difference between them, each under its name.

void draw_patterns(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns, Stage stage, const Rect& area,
                   const StageSize& size);

// Remarks on the first pattern: in `beside` if they fit in one line, otherwise at the top of
// `below`; returns the height used there.
float draw_remark(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                  Stage stage, const Rect& beside, const Rect& below);

// Stages that are not signals over time: spectrum, receptor grids, raster and relay networks.

void draw_spectrum_stage(Ui& ui, Physiology& physiology, const ShownStages& shown, const Rect& area,
                         bool large);
void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size);
// Legend of the maps' colours and marks, in the bottom line of large maps.
void draw_receptor_key(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                       const Rect& line);
void draw_spike_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, const Rect& area, const StageSize& size);
void draw_network_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                        const ShownStages& shown, const Rect& area, const StageSize& size);

// The same for networks.
void draw_network_key(const Ui& ui, const ShownStages& shown, const Rect& line);

// Width of the switch between maps from above and tilted ones, the control of the receptors' stage.
float view_choice_px(const Ui& ui);

// Remarks on a stage of one pattern that is easily misread: a filter leaks, a gate is nearly always
// open or closed, receptors lie beyond the finger, more impulses than cycles.
//
// Input     one pattern's stages
// Output    numbers of this pattern; a sentence, or an empty text

// Share of the steps in which the centre of a type's network sends anything.
double share_on(const LiveStages& live, Receptor receptor);

// Share of the steps in which it sends the model's maximum.
double share_at_cap(const LiveStages& live, Receptor receptor);

// Number of the grid's receptors beyond the finger's edge.
std::size_t beyond_finger(const LiveStages& live, Receptor receptor);

// Remark on one type's impulses, beside its rows: "filter leak", "11.5 a cycle"; empty: no remark.
std::string firing_note(const LiveStages& live, Receptor receptor);

// The same in a few words, for a small stage: types that only leak, types with many impulses a
// cycle.
std::string short_remark(const LiveStages& live, Stage stage);

// Remark for the line under a stage's title; empty: no remark. `has_textbook`: leaves out whatever
// the measured facts over the stage say.
std::string stage_remark(const LiveStages& live, Stage stage, bool has_textbook = false);

// The strip above the stages: the large stage, and the pattern shown for comparison.

// The strip; links to compare, to the tour and back to one row stand at the right end of its last
// line, or below it, or in a menu if it has two lines already. Returns the pressed links.
// `tour_begun`: offers to continue the tour.
StagesAction draw_strip(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun);

// Measured facts over a stage, if they are switched on, and the model's deviations from them.
//
// Source    model/textbook

// Lines at the top of `below`, limited so that a large stage keeps most of its room; for a pair,
// the difference that people notice. Returns the height used there.
float draw_textbook(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                    Stage stage, const Rect& below);

// A small stage with a deviation: a few words at the bottom of its label, and the lines as a
// tooltip. Returns the height used.
float draw_textbook_sign(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                         Stage stage, const Rect& label);

// The part for the spectrum; null while the switch is off.
struct MeasuredSpectrum {
    std::vector<std::pair<double, double>> felt_db;
    std::vector<MeasuredBand> bands;
};
MeasuredSpectrum measured_spectrum(const Physiology& physiology);

}  // namespace tact
