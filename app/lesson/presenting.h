// A lesson on a projector: the whole screen, large text, a clicker's keys, a blank screen, a
// visible pointer, and notes for the speaker.
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

// Presents the running lesson, or the last open one, or the tour; called again, returns to the
// window.
// A lesson of the open set: one step for the map, and one for each pattern that counts. It names
// patterns of the document, and has no set of its own.
Lesson lesson_of_set(const Workspace& work);

// Presents the running lesson, or the open set, or the tour if the set is empty. A lesson of the
// set ends with presenting.
void toggle_presenting(const LessonContext& context, LessonState& state);

bool is_presenting(const LessonState& state);

// Magnification against a screen of 1280 x 720, at most 4: a class sees the screen as a whole,
// whatever its number of pixels and the distance of its owner.
float presented_growth(ImVec2 screen_px);

// Handles the keys that belong to lessons; leaves the rest of the program's.
std::vector<KeyPress> take_lesson_keys(const LessonContext& context, LessonState& state,
                                       std::span<const KeyPress> pressed);

// Drawn over everything: the blank screen, and a ring around the moving mouse.
void draw_over_presentation(Ui& ui, const LessonState& state);

}  // namespace tact
