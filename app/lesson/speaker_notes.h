// What only the person who speaks is to see: the step's note, its answer, what comes next and how
// long it has been. In a second window, or as a line of the terminal.
#pragma once

#include <optional>
#include <string>

#include "app/lesson/lesson.h"
#include "app/screen/window.h"

namespace tact {

struct SpeakerNotes {
    std::string count;   // "3 of 18"
    std::string title;   // of the step
    std::string note;    // empty: it has none
    std::string answer;  // of its question
    std::string next;    // the next step's title; empty: this is the last
    int minutes = 0;     // of presenting

    bool operator==(const SpeakerNotes&) const = default;
};

// None while nothing is presented.
std::optional<SpeakerNotes> speaker_notes(const LessonState& state, double now_s);

// On one line, with its numbers.
std::string speaker_line(const LessonState& state);

void draw_speaker_notes(const Theme& theme, const SpeakerNotes& notes);

// The second window: where there is a second screen, or where it was asked for.
bool wants_notes_window(const LessonState& state, bool second_screen);
SideContent notes_window(const SpeakerNotes& notes, bool dark);

// N: shows or hides it.
void toggle_notes(LessonState& state);

// Until the next minute begins, which the notes tell.
double notes_wake_s(const LessonState& state, double now_s);

}  // namespace tact
