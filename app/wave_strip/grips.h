// What the wave strip can be taken by, and what a pattern becomes when it is.
//
// Two lanes over one time axis: amplitude in g above, the first carrier's frequency below. The line
// of a lane is its curve, or one level where there is none. A line is dragged as a whole, a click
// on it makes a point, and points, ramps, bursts, notes and the end are dragged by themselves.
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
    frequency,  // of the first carrier, or its whole curve
    amplitude_point,
    frequency_point,
    transient,
    attack,
    release,
    note_start,  // of a note of the rhythm, and so of its repetitions
    note,        // moved as a whole
    note_end,
    note_top,  // its strength
    end        // of the pattern
};

// What a press on the strip means where nothing lies: each tool takes its own things, the ends of
// the pattern too.
enum class StripTool {
    curves,  // lines and their points, ramps; and all that the others take, where nothing is in
             // its way
    notes,   // drawn, moved and resized, their tops their strength
    ticks    // transients: a press puts one
};

struct Grip {
    GripKind kind = GripKind::level;
    std::size_t index = 0;  // of a point, a transient or a note

    bool operator==(const Grip&) const = default;
};

// Points and transients: those that can be chosen, nudged and removed.
bool is_single(GripKind kind);

inline constexpr double kOverhead = 1.2;  // of the axis of strength over what it shows

struct StripScale {
    Plot amplitude;  // s, g from 0
    Plot frequency;  // s, Hz, logarithmic
    // Height of the notes' blocks at full strength, at the bottom of the amplitude lane: a row
    // there, or for the tool of notes up to the amplitude.
    float note_px = 0.0F;
    StripTool tool = StripTool::curves;
};

// The lowest and the highest frequency of the first carrier, by its curve and the pitches of notes.
Range carrier_range_hz(const Pattern& pattern);

// The g axis reaches over `peak_g` and everything that can be taken.
StripScale strip_scale(const Pattern& pattern, double peak_g, const Rect& area, const Theme& theme,
                       const TimeRange& view, StripTool tool = StripTool::curves);

struct PlacedGrip {
    Grip grip;
    ImVec2 at;
};

// All but the lines and the end, those that are taken first last. Points of a curve, or transients,
// of which more than 1,000 are in view have none until the view is narrower.
std::vector<PlacedGrip> placed_grips(const Pattern& pattern, const StripScale& scale);

// What is within reach of the mouse; of several, what lies on top.
std::optional<Grip> grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                            float reach_px);

struct GripDrag {
    ImVec2 from, to;
    bool along_one_axis = false;  // the one along which it went further; a note keeps to beats
    bool free = false;            // of the snaps: 5 ms, 0.01 g, 1 Hz; of a rhythm's, to quarters
};

Pattern dragged(const Pattern& before, const Grip& grip, const StripScale& scale,
                const GripDrag& drag);

// Whether what the grip changes is changed in all patterns that are selected. Not where it is of
// one pattern alone: a point, a burst, a curve of frequency.
bool is_shared(GripKind kind, const Pattern& pattern);

// Of a shared one: `to` gets what the grip changed in `from`.
void copy_change(GripKind kind, const Pattern& from, Pattern& to);

// A point on a line at the time, snapped, which is the grip; of an empty curve, points at both ends
// as well, so that a drag bends it. None: there is no room for one.
std::optional<Grip> add_point(Pattern& pattern, GripKind line, double time_s);
std::optional<Grip> add_transient(Pattern& pattern, double time_s, double amplitude_g);

// The point or the transient after `from` in time, or before it where `step` is -1: round from one
// end to the other. None has been chosen: the first, or the last. None: there is nothing.
std::optional<Grip> next_single(const Pattern& pattern, std::optional<Grip> from, int step);

void remove(Pattern& pattern, const Grip& grip);
bool exists(const Pattern& pattern, const Grip& grip);

// "amplitude", "frequency curve": the end of a step's label.
const char* name_of(GripKind kind);

// What a press would do; on nothing, with a tool.
const char* help_on(GripKind kind);
const char* help_on(StripTool tool);
const char* name_of(StripTool tool);  // "Notes"

}  // namespace tact
