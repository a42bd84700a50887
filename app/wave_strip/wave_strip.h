// The pattern drawn to scale, taken by the mouse.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "model/algebra/chosen_notes.h"
#include "model/pattern/pattern.h"
#include "model/signal/waveform.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/plot.h"

namespace tact {

// Grips of the wave strip, and the pattern that results from dragging one.
//
// Two lanes share one time axis: amplitude in g above, the first carrier's frequency below. The
// line of a lane is its curve, or a constant level. A drag moves a whole line, a click on it adds a
// point; points, ramps, bursts, notes and the end are dragged by themselves.
//
// Input     the pattern and the scale as they were when the mouse was pressed
// Output    a pattern without fault (model/pattern/drawn_fault.h)

enum class GripKind {
    level,      // the amplitude, or its whole curve
    frequency,  // frequency of the first carrier, or its whole curve
    amplitude_point,
    frequency_point,
    transient,
    attack,
    release,
    note_start,  // of a note of the rhythm with all its repetitions
    note,        // moves the whole note
    note_end,
    note_top,  // the note's strength
    end        // end of the pattern
};

// The meaning of a press on an empty place: each tool has its own grips, and all have the ends of
// the pattern.
enum class StripTool {
    curves,  // lines and their points, ramps; also the grips of other tools if nothing covers them
    notes,   // draws, moves and resizes notes; their tops are their strength
    ticks    // transients: a press adds one
};

struct Grip {
    GripKind kind = GripKind::level;
    std::size_t index = 0;  // index of a point, a transient or a note

    bool operator==(const Grip&) const = default;
};

// Points and transients, which can be chosen, nudged and removed.
bool is_single(GripKind kind);

inline constexpr double kOverhead = 1.2;  // top of the strength axis over the highest grip

struct StripScale {
    Plot amplitude;  // s, g from 0
    Plot frequency;  // s, Hz, logarithmic
    // Height of the notes' blocks at full strength, at the bottom of the amplitude lane: a low row,
    // or with the tool of notes up to the amplitude.
    float note_px = 0.0F;
    StripTool tool = StripTool::curves;
};

// The lowest and the highest frequency of the first carrier, from its curve and the pitches of
// notes.
Range carrier_range_hz(const Pattern& pattern);

// The g axis covers `peak_g` and all grips.
StripScale strip_scale(const Pattern& pattern, double peak_g, const Rect& area, const Theme& theme,
                       const TimeRange& view, StripTool tool = StripTool::curves);

struct PlacedGrip {
    Grip grip;
    ImVec2 at;
};

// All grips but the lines and the end; later ones lie on top. If more than 1,000 points of a curve,
// or transients, are in view, they have no grips until the view is narrower.
std::vector<PlacedGrip> placed_grips(const Pattern& pattern, const StripScale& scale);

// The grip within reach of the mouse; the topmost of several.
std::optional<Grip> grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                            float reach_px);

struct GripDrag {
    ImVec2 from, to;
    bool along_one_axis = false;  // the axis with the longer movement; a note keeps to beats
    bool free = false;            // without snapping to 5 ms, 0.01 g, 1 Hz; notes snap to quarter
                                  // steps
};

Pattern dragged(const Pattern& before, const Grip& grip, const StripScale& scale,
                const GripDrag& drag);

// Whether the grip changes all selected patterns. Grips of one pattern alone do not: points,
// bursts, a curve of frequency.
bool is_shared(GripKind kind, const Pattern& pattern);

// For a shared grip: copies to `to` what the grip changed in `from`.
void copy_change(GripKind kind, const Pattern& from, Pattern& to);

// Adds a point to a line at this time, snapped, and returns its grip; an empty curve gets points at
// both ends as well, so that a drag bends it. Nullopt: no room for a point.
std::optional<Grip> add_point(Pattern& pattern, GripKind line, double time_s);
std::optional<Grip> add_transient(Pattern& pattern, double time_s, double amplitude_g);

// The point or transient after `from` in time, or before it if `step` is -1; after the last comes
// the first. Without `from`: the first, or the last. Nullopt: there is no point.
std::optional<Grip> next_single(const Pattern& pattern, std::optional<Grip> from, int step);

void remove(Pattern& pattern, const Grip& grip);
bool exists(const Pattern& pattern, const Grip& grip);

// The end of a step's label: "amplitude", "frequency curve".
const char* name_of(GripKind kind);

// The effect of a press on a grip, or with a tool on an empty place.
const char* help_on(GripKind kind);
const char* help_on(StripTool tool);
const char* name_of(StripTool tool);  // "Notes"

// State of the wave strip between frames.

// A drag, from the press of the mouse to its release.
struct GripHold {
    Grip grip;
    Pattern before;
    StripScale scale;  // does not change during a drag, so that the grip stays at the mouse
    ImVec2 pressed;
    bool moved = false;
    const char* verb = "Change";  // in the label of the step of undo
    ChosenNotes notes{};          // chosen together with the held one
};

// A box that chooses the notes inside it, in px, until the mouse is released.
struct NoteBox {
    float from_px = 0.0F;
    float to_px = 0.0F;
    StripScale scale;
};

// The sum of the other layers, starting where the open one begins.
struct LayersBeneath {
    std::uint64_t revision = 0;  // the document's revision
    Waveform waveform;
};

inline constexpr Range kStripHeight{120.0, 900.0};  // px at scale 1

// The name of the chosen item's own number, which arrows nudge.
inline constexpr const char* kChosenValue = "chosen_value";

struct StripState {
    std::string pattern;  // name of the pattern, and its layer's; everything below but height and
                          // tool belongs to it
    std::optional<GripHold> held;
    std::optional<Grip> chosen;  // a point or a transient, whose numbers are shown
    ChosenNotes notes;           // with the tool of notes
    std::optional<NoteBox> box;
    std::optional<LayersBeneath> beneath;
    std::optional<double> pointed_s;  // time under the mouse, where notes are pasted
    bool is_scrubbed = false;         // the playhead is dragged on the ruler
    bool has_just_drawn = false;      // the last press added an item at an empty place
    bool is_scrolled_past = false;    // the wheel scrolls the pane, with the strip in it
    float height = 150.0F;            // within kStripHeight
    StripTool tool = StripTool::curves;
};

// Several notes chosen on the strip with the tool of notes, and edits of all of them.
//
// A click chooses a note; with Shift it adds or removes one. A drag on an empty place with Shift
// chooses the notes inside. Moving, strengthening, copying, pasting, doubling and repeating them
// are one step of undo each (model/algebra/chosen_notes.h).

inline constexpr int kRepeats = 4;  // of a bar, including the first: the most common number

// Whether notes are chosen in the pattern in the editor, which can be edited.
bool has_chosen_notes(const Workspace& work, const StripState& strip);

// Gives the selected patterns this rhythm, and lengthens those that are too short for it.
void take_rhythm(Workspace& work, const Pattern& before, const Pattern& changed);

// Chooses the note alone, or adds it to those chosen before.
void choose_note(StripState& strip, const Pattern& pattern, std::size_t index);
void toggle_note(StripState& strip, const Pattern& pattern, std::size_t index);

// Chooses the notes inside a box, in whole steps; a box no wider than a click is ignored.
void choose_boxed(StripState& strip, const Pattern& pattern, float click_px);

// A drag of one of several chosen notes moves all; a drag of its top makes all stronger. False:
// only one is chosen.
bool drag_chosen_notes(Ui& ui, Workspace& work, StripState& strip, const GripDrag& drag);

// One step of undo: "Repeat notes of p1".
void commit_notes(Ui& ui, Workspace& work, StripState& strip, const char* verb,
                  const Expected<NotesEdit>& edit);

// Commands for patterns apply to chosen notes first. False: no notes are chosen.
bool copy_notes(Ui& ui, const Workspace& work, const StripState& strip);
bool repeat_notes(Ui& ui, Workspace& work, StripState& strip, int times);
bool remove_notes(Ui& ui, Workspace& work, StripState& strip);
bool choose_all_notes(Ui& ui, const Workspace& work, StripState& strip);

// Pastes a text of steps from the clipboard, at the mouse over the strip or at the playhead. False:
// the clipboard has no steps, or another tool is in use.
bool paste_notes(Ui& ui, Workspace& work, StripState& strip, double playhead_s);

// For keys: chooses the next note, or the one before; after the last comes the first.
void choose_next_note(Ui& ui, StripState& strip, const Pattern& pattern, int step);

// The picture of the wave strip: the wave, its lines, and grips.

struct StripScene {
    const Pattern& pattern;
    const StripScale& scale;
    const Waveform* waveform = nullptr;  // null: not rendered yet
    ImU32 colour = 0;
    std::optional<Grip> chosen{};
    std::optional<Grip> under{};  // the mouse
    bool hovered = false;
    ChosenNotes notes{};
    std::optional<NoteBox> box{};
    std::optional<double> playhead_s{};
    const Waveform* ghost = nullptr;  // below everything else, dim, with its name
    std::string ghost_words{};
    bool is_ruler_hovered = false;
};

void draw_strip_picture(ImDrawList& list, const Theme& theme, const Rect& area,
                        const StripScene& scene);

// The selected pattern drawn to scale, with grips for the mouse.

// The time axis of all views. The strip shows the range and a little more at the right, where the
// grip of the pattern's end is.
struct StripTime {
    TimeRange range;  // length 0: the whole pattern
    double playhead_s = 0.0;
};

// The strip's share of its pane.
struct StripRoom {
    float most_px;
    bool fills = false;  // fills the height; false: the height set by the person, if there is room
};

// As wide as the rest of the pane; draws nothing without a parametric pattern.
void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, StripTime& time,
                     const StripRoom& room);

// The numbers of the chosen item, if any, with a line below them; and their height in px at the
// width of the rest of the pane.
void draw_chosen_fields(Ui& ui, Workspace& work, StripState& strip);
float chosen_fields_px(const Ui& ui, const Workspace& work, const StripState& strip);

// Including the bar under it, in px.
float strip_height(const Ui& ui, const StripState& strip);

// For keys: adds a point to a line (`level` or `frequency`), or a transient, at a time; and chooses
// the next point or transient, or the one before, or a note with the tool of notes. The chosen
// item's numbers are shown and nudged.
void add_at(Ui& ui, Workspace& work, StripState& strip, GripKind kind, double time_s);
void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step);

// Del removes the chosen point, transient or notes. False: none was chosen.
bool remove_chosen(Ui& ui, Workspace& work, StripState& strip);

}  // namespace tact
