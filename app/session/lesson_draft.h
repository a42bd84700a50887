// A lesson that is being written outlives the program as the document does: in a file beside the
// document's autosave, written whole or not at all, for this user alone.
//
// Input     the lesson after each change; the caller waits for pauses
// Output    the lesson of the last run, or a lesson file of its own for what would be lost
// Left out  its undo steps.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "model/common/expected.h"
#include "model/lesson/lesson.h"

namespace tact {

struct LessonDraft {
    Lesson lesson;               // with its set; recordings by absolute path
    std::filesystem::path path;  // of its file; empty: it has none
    std::size_t step = 0;        // that is written
};

// autosave-7.json of a document lies beside autosave-7.lesson.
std::filesystem::path lesson_autosave(const std::filesystem::path& autosave_file);

// Keeps the lesson; none: forgets what was kept. An Error: it is in memory alone.
Expected<Done> autosave_lesson(const Session& session, const std::optional<LessonDraft>& draft);

struct RestoredLesson {
    std::optional<LessonDraft> draft;  // none: no lesson was unsaved, or it cannot be read
    std::string remark;                // one sentence for the status line; may be empty
    bool is_error = false;             // of the remark
};

// The lesson of the last run. An autosave that cannot be read is kept aside.
RestoredLesson restore_lesson(Session& session);

// Moves an autosave to a recovered-YYYYMMDD-HHMMSS.tactlesson.json that heads the recent files; one
// that is no autosave keeps its bytes there. Empty: no such file.
Expected<std::filesystem::path> set_lesson_aside(Session& session,
                                                 const std::filesystem::path& lesson_file);

}  // namespace tact
