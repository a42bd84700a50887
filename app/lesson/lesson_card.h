// The card of a step: text, question, the class's answers, and buttons. It stands beside the panes,
// never over them.
//
// Output    the card's place and the rest of the window, which do not overlap
#pragma once

#include "app/lesson/lesson.h"
#include "viz/drawing/geometry.h"

namespace tact {

struct LessonPlaces {
    Rect card;  // empty: no lesson is running
    Rect rest;
};

// Fonts of the card: larger while presenting, for the last row of the class.
struct LessonFonts {
    ImFont* text;
    ImFont* head;
    ImFont* small;
};
LessonFonts lesson_fonts(const Ui& ui, const LessonState& state);

// Pure, for tests.
LessonPlaces lesson_places(const Ui& ui, const LessonState& state, const Rect& area);

void draw_lesson_card(const LessonContext& context, LessonState& state, const LessonPlaces& places);

// An outline around the item that the step points at, as drawn in this frame.
void watch_pointed(Ui& ui, const LessonState& state);
void draw_pointed(const Ui& ui, const Rect& within);

// Reveals a hidden answer, or goes to the next step. `back`: goes to the step before.
void step_on(const LessonContext& context, LessonState& state);
void step_back(const LessonContext& context, LessonState& state);

// All text of the lesson in the shown language: decides which glyphs are loaded.
std::string drawn_text(const LessonState& state);

// Loads fonts again if a step has characters that they lack; characters that no font has stay
// lacking.
void follow_glyphs(Ui& ui, LessonState& state);

// Moves the card to the next edge of the window.
void move_card(LessonState& state);

}  // namespace tact
