// The card of a step: text, question, what the class said, the way on. It stands beside what it
// speaks of, never over it.
//
// Output    where it stands and what is left of the window; the two do not meet
#pragma once

#include "app/lesson/lesson.h"
#include "viz/drawing/geometry.h"

namespace tact {

struct LessonPlaces {
    Rect card;  // empty: no lesson is under way
    Rect rest;
};

// Its type: larger while presenting, for those at the back.
struct LessonFonts {
    ImFont* text;
    ImFont* head;
    ImFont* small;
};
LessonFonts lesson_fonts(const Ui& ui, const LessonState& state);

// Pure, for tests.
LessonPlaces lesson_places(const Ui& ui, const LessonState& state, const Rect& area);

void draw_lesson_card(const LessonHands& hands, LessonState& state, const LessonPlaces& places);

// An outline around what the step points at, as it was drawn in this frame.
void watch_pointed(Ui& ui, const LessonState& state);
void draw_pointed(const Ui& ui, const Rect& within);

// Reveals the answer, where one is asked and hidden; else the next step, or the end. `back`: the
// step before.
void step_on(const LessonHands& hands, LessonState& state);
void step_back(const LessonHands& hands, LessonState& state);

// All that is written in the lesson, in the language that is shown: for the choice of glyphs.
std::string drawn_text(const LessonState& state);

// Fonts are loaded again where a step has characters that they lack; what lacks then is lacking.
void follow_glyphs(Ui& ui, LessonState& state);

// The next edge of the window.
void move_card(LessonState& state);

}  // namespace tact
