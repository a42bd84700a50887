// Placing a pattern in the map oneself: the map hides it until the answer is revealed, then shows
// the distance between the two places.
//
// Input     the left mouse button in the map, or Shift and the arrows; the map is flat meanwhile
// Output    a cross at the chosen place, and a line to the model's place
#pragma once

#include <optional>
#include <string>

#include "app/lesson/lesson.h"
#include "app/map/map_look.h"
#include "app/map/space_panel.h"
#include "app/screen/input_queue.h"

namespace tact {

// Whether the current step asks for a place.
bool asks_for_place(const LessonState& state);

// The part of it that the map shows.
void mark_place(const LessonState& state, const ShownMap& shown_map, MapMarks& marks);

// Takes the clicks and keys of the map.
void take_place(LessonState& state, const SpacePaneAction& done);
bool nudge_place(LessonState& state, const ShownMap& shown_map, const KeyPress& press);

// Distance from the model's place, as a share of the map's width: the largest distance between two
// points. Nullopt without a place or a map.
std::optional<double> place_off_by(const LessonState& state, const ShownMap& shown_map);
std::string place_text(const LessonState& state, const ShownMap& shown_map);

// Without votes, the pattern nearest to the place counts as one vote.
void count_place(LessonState& state, const ShownMap& shown_map);

}  // namespace tact
