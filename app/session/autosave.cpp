#include "app/session/session.h"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "model/io/folders/path_json.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What an autosave file holds.
struct Kept {
    std::string set_text;  // a set file; recordings by absolute path, as in memory
    fs::path path;         // of the document; empty: it has none
    std::optional<std::uint64_t> file_mark{};  // of the document's file, as it was known
};

void erase_file(const fs::path& path) {
    std::error_code none;
    fs::remove(path, none);
}

std::string text_of(const Kept& kept) {
    json all = {{"format", 1}, {"path", path_json(kept.path)}, {"set", kept.set_text}};
    if (kept.file_mark) all["file_mark"] = *kept.file_mark;
    return text_of_json(all, 1) + "\n";
}

std::optional<Kept> read_kept(const fs::path& file) {
    const Expected<std::string> text = read_text_file(file);
    if (!text) return std::nullopt;
    const json all = kept_sorted_json(*text);
    if (!all.is_object() || all.value("format", json()) != 1) return std::nullopt;
    const json set = all.value("set", json());
    const std::optional<fs::path> path = path_of(all.value("path", json()));
    if (!set.is_string() || !path) return std::nullopt;
    Kept kept{set.get<std::string>(), *path};
    const json mark = all.value("file_mark", json());
    if (mark.is_number_unsigned()) kept.file_mark = mark.get<std::uint64_t>();
    return kept;
}

// As the document had it; `saved` is what is on the disk now.
Expected<Document> document_of(const Kept& kept, const fs::path& file) {
    Expected<PatternSet> set = parse_set(kept.set_text, file.string(), file.parent_path());
    if (!set) return set.error();
    Document document{*std::move(set), kept.path, {}, kept.file_mark};
    if (document.path.empty()) return document;
    if (Expected<Loaded> saved = load_set(document.path)) document.saved = std::move(saved->set);
    return document;
}

// Turns an autosave into a set file. One that is no autosave keeps its bytes under the new name.
Expected<fs::path> move_aside(Session& session, const fs::path& autosave_file) {
    const fs::path file = unused_file(session.folder, "recovered-", ".tactspace.json");
    if (const std::optional<Kept> kept = read_kept(autosave_file)) {
        if (const auto written = write_atomically(file, kept->set_text, kPrivateFile); !written) {
            return written.error();
        }
        erase_file(autosave_file);
    } else {
        std::error_code failure;
        fs::rename(autosave_file, file, failure);
        if (failure) return Error{file.string() + ": cannot be written: " + failure.message()};
    }
    remember_file(session, file);
    return file;
}

std::string name_of(const Document& document) {
    return document.path.empty() ? "a set that has no file yet" : document.path.filename().string();
}

Restored restore_changes(Session& session) {
    const std::optional<Kept> kept = read_kept(session.autosave);
    Expected<Document> document =
        kept ? document_of(*kept, session.autosave) : Error{"no autosave of this program"};
    if (!document) {
        const std::string reason = document.error().message;
        const Expected<fs::path> file = move_aside(session, session.autosave);
        return {{},
                "Unsaved changes could not be read; they are kept in " +
                    (file ? *file : session.autosave).string() + ". " + reason,
                true};
    }
    const std::string remark = "Recovered unsaved changes of " + name_of(*document) +
                               (session.ended_in_crash ? " after a crash." : ".");
    return {*std::move(document), remark, false};
}

}  // namespace

fs::path lock_of(const fs::path& autosave_file) {
    constexpr std::string_view kPrefix = "autosave-";
    const std::string stem = autosave_file.stem().string();
    if (!stem.starts_with(kPrefix)) return autosave_file.parent_path() / "lock";
    return autosave_file.parent_path() / (stem.substr(kPrefix.size()) + ".lock");
}

Expected<Done> autosave(const Session& session, const Document& document) {
    if (document.set == document.saved) {
        if (!session.folder.empty()) erase_file(session.autosave);
        return Done{};
    }
    if (session.folder.empty()) {
        return Error{
            "there is no folder to keep them in, expected XDG_STATE_HOME or HOME to name "
            "one that can be written"};
    }
    return write_atomically(session.autosave,
                            text_of({print_set(document.set), document.path, document.file_mark}),
                            kPrivateFile);
}

Restored restore(Session& session) {
    if (session.folder.empty()) return {};
    if (is_there(session.autosave)) return restore_changes(session);
    if (session.document.empty()) return {};
    const std::optional<std::uint64_t> mark = content_mark(session.document);
    Expected<Loaded> loaded = load_set(session.document);
    if (!loaded) return {{}, loaded.error().message, true};
    return {Document{loaded->set, session.document, loaded->set, mark}, {}, false};
}

Expected<fs::path> set_autosave_aside(Session& session) {
    if (session.folder.empty() || !is_there(session.autosave)) return fs::path{};
    return move_aside(session, session.autosave);
}

void recover_orphans(Session& session) {
    std::error_code failure;
    std::vector<fs::path> files;
    for (fs::directory_iterator at(session.folder, failure), end; !failure && at != end;
         at.increment(failure)) {
        const std::string name = at->path().filename().string();
        const bool is_kept = name.ends_with(".json") || name.ends_with(".lesson");
        if (name.starts_with("autosave-") && is_kept) files.push_back(at->path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) {
        const std::optional<FileLock> lock = try_lock(lock_of(file));
        if (!lock) continue;  // its instance is still running
        const bool is_lesson = file.extension() == ".lesson";
        const Expected<fs::path> moved =
            is_lesson ? set_lesson_aside(session, file) : move_aside(session, file);
        if (moved) session.recovered.push_back(*moved);
        erase_file(lock_of(file));
    }
}

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
