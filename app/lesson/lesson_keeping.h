// Nothing that was written in a lesson is lost: it is kept beside the document's autosave while it
// is unsaved, asked about before another takes its place, and kept in a file of its own otherwise.
//
// A lesson is unsaved where it was edited and differs from what was last begun, read or written.
// The set of a lesson that was begun from the document is the document's, and kept with it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/lesson/lesson.h"
#include "app/session/lesson_draft.h"

namespace tact {

// As it would be saved now; null: nothing of it is unsaved.
std::shared_ptr<const Lesson> unsaved_lesson(const Workspace& work, const LessonState& state);

// What is on screen is in a file now, or as it was begun.
void note_lesson_saved(const Workspace& work, LessonState& state);

// Once a frame: writes the autosave when it is due, beside the window.
void autosave_lesson_if_due(Ui& ui, Workspace& work, LessonState& state);
bool is_autosaving(const LessonState& state);

// The autosave at once.
Expected<Done> keep_lesson(const Workspace& work, LessonState& state);

// What was written is let go: it is kept for the next start, or not wanted.
void let_lesson_go(LessonState& state);

// Moves what is unsaved to a lesson file of its own, which heads the recent ones; false: it cannot
// be kept, and the lesson has to stay. `state.kept_in` tells where it is.
bool set_lesson_aside(const LessonHands& hands, LessonState& state,
                      const std::shared_ptr<const Lesson>& unsaved);

// Asks where something is unsaved, and does `then` once it is saved, or to be kept as a draft.
void before_lesson_goes(const LessonHands& hands, LessonState& state, std::function<void()> then);

// As the last run left it: it is written on, and still unsaved.
void resume_lesson(const LessonHands& hands, LessonState& state, LessonDraft draft);

}  // namespace tact
