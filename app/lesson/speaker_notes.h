// Notes that only the speaker sees: the step's note, its answer, the next title and the elapsed
// time, in a second window or as a line of the terminal.
#pragma once

#include <optional>
#include <string>

#include "app/lesson/lesson.h"
#include "app/screen/window.h"

namespace tact {

struct SpeakerNotes {
    std::string count;   // "3 of 18"
    std::string title;   // the step's title
    std::string note;    // empty: no note
    std::string answer;  // answer to its question
    std::string next;    // the next step's title; empty: last step
    int minutes = 0;     // elapsed time of presenting

    bool operator==(const SpeakerNotes&) const = default;
};

// Nullopt unless presenting.
std::optional<SpeakerNotes> speaker_notes(const LessonState& state, double now_s);

// One line, with its numbers.
std::string speaker_line(const LessonState& state);

void draw_speaker_notes(const Theme& theme, const SpeakerNotes& notes);

// The second window: shown on a second screen, or on request.
bool wants_notes_window(const LessonState& state, bool second_screen);
SideContent notes_window(const SpeakerNotes& notes, bool dark);

// N: shows or hides the notes.
void toggle_notes(LessonState& state);

// Seconds until the elapsed minutes in the notes change.
double notes_wake_s(const LessonState& state, double now_s);

}  // namespace tact
