#include "app/session/lesson_draft.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/session/folders.h"
#include "model/io/folders/path_json.h"
#include "model/io/lesson/lesson_file.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What an autosave holds.
struct KeptLesson {
    std::string lesson_text;  // a lesson file; recordings by absolute path
    fs::path path;
    std::size_t step = 0;
};

std::string text_of(const LessonDraft& draft) {
    const json all = {{"format", 1},
                      {"path", path_json(draft.path)},
                      {"step", draft.step},
                      {"lesson", print_lesson(draft.lesson, {})}};
    return text_of_json(all, 1) + "\n";
}

std::optional<KeptLesson> read_kept_lesson(const fs::path& file) {
    const Expected<std::string> text = read_text_file(file);
    if (!text) return std::nullopt;
    const json all = kept_sorted_json(*text);
    if (!all.is_object() || all.value("format", json()) != 1) return std::nullopt;
    const json lesson = all.value("lesson", json());
    const json step = all.value("step", json());
    const std::optional<fs::path> path = path_of(all.value("path", json()));
    if (!lesson.is_string() || !path || !step.is_number_unsigned()) return std::nullopt;
    return KeptLesson{lesson.get<std::string>(), *path, step.get<std::size_t>()};
}

Expected<LessonDraft> draft_of(const KeptLesson& kept, const fs::path& file) {
    Expected<Lesson> lesson = parse_lesson(kept.lesson_text, file.string(), file.parent_path());
    if (!lesson) return lesson.error();
    const std::size_t step = std::min(kept.step, lesson->steps.size() - 1);
    return LessonDraft{*std::move(lesson), kept.path, step};
}

}  // namespace

fs::path lesson_autosave(const fs::path& autosave_file) {
    return fs::path(autosave_file).replace_extension(".lesson");
}

Expected<Done> autosave_lesson(const Session& session, const std::optional<LessonDraft>& draft) {
    if (!draft) {
        std::error_code none;
        if (!session.folder.empty()) fs::remove(lesson_autosave(session.autosave), none);
        return Done{};
    }
    if (session.folder.empty()) {
        return Error{
            "there is no folder to keep it in, expected XDG_STATE_HOME or HOME to name one that "
            "can be written"};
    }
    return write_atomically(lesson_autosave(session.autosave), text_of(*draft), kPrivateFile);
}

RestoredLesson restore_lesson(Session& session) {
    const fs::path file = lesson_autosave(session.autosave);
    if (session.folder.empty() || !is_there(file)) return {};
    const std::optional<KeptLesson> kept = read_kept_lesson(file);
    Expected<LessonDraft> draft =
        kept ? draft_of(*kept, file) : Error{"no autosave of this program"};
    if (draft) {
        const std::string remark = "Recovered the unsaved lesson " + draft->lesson.name +
                                   (session.ended_in_crash ? " after a crash." : ".");
        return {*std::move(draft), remark, false};
    }
    const std::string reason = draft.error().message;
    const Expected<fs::path> aside = set_lesson_aside(session, file);
    return {{},
            "An unsaved lesson could not be read; it is kept in " +
                (aside ? *aside : file).string() + ". " + reason,
            true};
}

Expected<fs::path> set_lesson_aside(Session& session, const fs::path& lesson_file) {
    if (session.folder.empty() || !is_there(lesson_file)) return fs::path{};
    const fs::path file = unused_file(session.folder, "recovered-", ".tactlesson.json");
    std::error_code failure;
    if (const std::optional<KeptLesson> kept = read_kept_lesson(lesson_file)) {
        const auto written = write_atomically(file, kept->lesson_text, kPrivateFile);
        if (!written) return written.error();
        fs::remove(lesson_file, failure);
    } else {
        fs::rename(lesson_file, file, failure);
        if (failure) return Error{file.string() + ": cannot be written: " + failure.message()};
    }
    remember_file(session, file);
    return file;
}

}  // namespace tact
