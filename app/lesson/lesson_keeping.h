// Autosave of lessons: an unsaved lesson is written beside the document's autosave, the person is
// asked before another lesson replaces it, and otherwise it gets a file of its own.
//
// A lesson is unsaved if it was edited and differs from the last version begun, read or written.
// The set of a lesson that was begun from the document is the document's, and saved with it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/lesson/lesson.h"
#include "app/session/lesson_draft.h"

namespace tact {

// The lesson to be saved; null: everything is saved.
std::shared_ptr<const Lesson> unsaved_lesson(const Workspace& work, const LessonState& state);

// Marks the lesson as saved, or as just begun.
void note_lesson_saved(const Workspace& work, LessonState& state);

// Once a frame: writes the autosave in the background when it is due.
void autosave_lesson_if_due(Ui& ui, Workspace& work, LessonState& state);
bool is_autosaving(const LessonState& state);

// Writes the autosave at once.
Expected<Done> keep_lesson(const Workspace& work, LessonState& state);

// Forgets unsaved changes: they are kept for the next start, or not wanted.
void let_lesson_go(LessonState& state);

// Moves unsaved changes to a lesson file of their own, which heads the recent ones, and sets
// `state.kept_in`. False: the file cannot be written, and the lesson has to stay open.
bool set_lesson_aside(const LessonContext& context, LessonState& state,
                      const std::shared_ptr<const Lesson>& unsaved);

// Calls `then` at once, or if something is unsaved, asks first and calls it once that is saved or
// kept as a draft.
void before_lesson_goes(const LessonContext& context, LessonState& state,
                        std::function<void()> then);

// Reopens the lesson that the last run left unsaved, in the editor.
void resume_lesson(const LessonContext& context, LessonState& state, LessonDraft draft);

}  // namespace tact
