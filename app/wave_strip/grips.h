// Grips of the wave strip, and the pattern that results from dragging one.
//
// Two lanes share one time axis: amplitude in g above, the first carrier's frequency below. The
// line of a lane is its curve, or a constant level. A drag moves a whole line, a click on it adds a
// point; points, ramps, bursts, notes and the end are dragged by themselves.
//
// Input     the pattern and the scale as they were when the mouse was pressed
// Output    a pattern without fault (model/pattern/drawn_fault.h)
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/pattern/pattern.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/time_range.h"

namespace tact {

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

}  // namespace tact
