// Notes and curves as points of one curve. Private to the room.
//
// Source    ours
// Output    curves by the rules of model/pattern/curves.h: at most two points at one time
#pragma once

#include "model/pattern/pattern.h"

namespace tact {

// Puts a point behind all others; of three at one time the first and the last stay.
void append_point(AmplitudeCurve& curve, double time_s, double value);

// The curve's value just before a time; value_at() gives its value from there on.
double value_before(const AmplitudeCurve& curve, double t_s);

// a(t) b(t) from 0 to the end; an empty curve is 1. Where both have a slope, 16 straight pieces.
AmplitudeCurve product(const AmplitudeCurve& a, const AmplitudeCurve& b, double end_s);

// From one time to another, as a curve from 0 s on.
AmplitudeCurve part_of_curve(const AmplitudeCurve& curve, double from_s, double to_s);

// Whether one note without ramps sounds throughout, so that nothing is to be drawn.
bool is_steady(const Pattern& pattern);

// The pattern with its rhythm and ramps in its amplitude curve, and pitches in that of frequency.
Pattern with_drawn_notes(Pattern pattern);

}  // namespace tact
