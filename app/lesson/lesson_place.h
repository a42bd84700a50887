// Placing a pattern in the map oneself: it is hidden there until the answer is seen, and then how
// far off the place was.
//
// Input     the left mouse button in the map, or Shift and the arrows; the map lies flat meanwhile
// Output    a cross where it was put, and a way to where the model puts it
#pragma once

#include <optional>
#include <string>

#include "app/lesson/lesson.h"
#include "app/map/map_look.h"
#include "app/map/space_panel.h"
#include "app/screen/input_queue.h"

namespace tact {

// The step under way asks for a place.
bool asks_for_place(const LessonState& state);

// What the map shows of it.
void mark_place(const LessonState& state, const ShownMap& shown_map, MapMarks& marks);

// What was done in the map.
void take_place(LessonState& state, const SpacePaneAction& done);
bool nudge_place(LessonState& state, const ShownMap& shown_map, const KeyPress& press);

// Of the map's width, which is the distance of the two points that lie farthest apart; none: there
// is no place or no map.
std::optional<double> place_off_by(const LessonState& state, const ShownMap& shown_map);
std::string place_text(const LessonState& state, const ShownMap& shown_map);

// With nobody's hand up, the pattern nearest to the place counts as one.
void count_place(LessonState& state, const ShownMap& shown_map);

}  // namespace tact
