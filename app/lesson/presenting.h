// A lesson on a projector: the whole screen, large text, a clicker's keys, a blank screen, a
// pointer that is seen, and notes for who speaks.
//
// Input     Page Up, Page Down, arrows, Enter, Space, Backspace, Home, End; B or full stop blanks;
//           P plays or halts; M moves the card; N shows the speaker's notes in a second window;
//           number keys vote; Esc and F5 leave
// Left out  the notes (speaker_notes.h)
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/lesson/lesson.h"
#include "app/screen/input_queue.h"

namespace tact {

// The lesson under way, else the one that was open last, else the tour, on the whole screen; or
// back to the window.
// A lesson of the open set: a step for the map, and one for each pattern that counts. It names
// patterns of the document, and has no set of its own.
Lesson lesson_of_set(const Workspace& work);

// The lesson under way where it is; else the open set, or the tour where that is empty. What shows
// the set ends with presenting.
void toggle_presenting(const LessonHands& hands, LessonState& state);

bool is_presenting(const LessonState& state);

// How much larger than on a screen of 1280 x 720 everything is, at most four times: a class sees a
// screen as a whole, however many pixels it has and however near to them its owner sits.
float presented_growth(ImVec2 screen_px);

// Keys that mean something to a lesson do it; those for the rest of the program are left.
std::vector<KeyPress> take_lesson_keys(const LessonHands& hands, LessonState& state,
                                       std::span<const KeyPress> pressed);

// Over everything: the screen black, and a ring around the mouse while it moves.
void draw_over_presentation(Ui& ui, const LessonState& state);

}  // namespace tact
