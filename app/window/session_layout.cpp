#include "app/window/window.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/opening/opening.h"
#include "app/play/play.h"
#include "app/session/session.h"
#include "app/study/study.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

void leave_study(App& app) {
    using What = StudyEvent::What;
    for (const What what : {What::ask, What::leave})
        act(app.ui, app.work, app.play, app.studying, {what, 0, 0.0, {}, {}});
}

// The person's own document, also while a lesson shows its set in place of it.
const EditedDocument& own_document(const App& app) {
    return app.lesson.aside ? app.lesson.aside->document : app.work.document;
}

// Writes the document for the next start; an Error tells why it could not.
Expected<Done> keep_document(App& app) {
    wait_for_autosave(app.work);
    return autosave(app.work.session, own_document(app).kept());
}

// Restores the person's document; the next start continues a tour where it was left, and an edited
// lesson in the editor.
void end_lesson(App& app) {
    if (!app.lesson.step) return;
    let_lesson_go(app.lesson);
    leave_lesson(lesson_context(app), app.lesson);
}

void discard_and_quit(App& app) {
    // Otherwise the end of the program would try to keep it once more.
    Document saved = app.work.document.kept();
    saved.set = saved.saved;
    app.work.document.open(std::move(saved));
    app.ui.quit = true;
}

// Restores the last session, or opens the example.
void take_up_session(App& app) {
    Restored restored = restore(app.work.session);
    if (restored.document) {
        Document document = *std::move(restored.document);
        app.work.document.open({});
        show_document(app.ui, app.work, std::move(document), restored.remark);
    } else {
        open_example(app.ui, app.work);
    }
    if (restored.is_error) complain(app.ui, restored.remark);
}

// Reopens the lesson that was being edited when the last run ended.
void take_up_lesson(App& app) {
    RestoredLesson restored = restore_lesson(app.work.session);
    if (restored.is_error) return complain(app.ui, restored.remark);
    if (!restored.draft) return;
    const std::string before = app.ui.status.text;
    resume_lesson(lesson_context(app), app.lesson, *std::move(restored.draft));
    say(app.ui, (before.empty() ? "" : before + " ") + restored.remark);
}

// Another lesson or set is opened at once: the edited one becomes the first of the recent files.
void set_last_lesson_aside(App& app) {
    Session& session = app.work.session;
    const auto aside = set_lesson_aside(session, lesson_autosave(session.autosave));
    if (!aside) return complain(app.ui, with_stop(aside.error().message));
    if (!aside->empty()) session.recovered.push_back(*aside);
}

// Opens the paths instead of the session, once unsaved changes in it are safe.
Expected<Done> open_instead(App& app, const std::vector<std::filesystem::path>& paths) {
    const Expected<std::filesystem::path> aside = set_autosave_aside(app.work.session);
    if (!aside) {
        take_up_session(app);
        refuse_to_replace(app.ui, aside.error().message);
        return Done{};
    }
    open_paths(app.ui, app.work, app.opening, paths);
    if (app.ui.status.is_error) return Error{app.ui.status.text};
    if (!aside->empty()) {
        app.ui.status.text +=
            " Unsaved changes of the last session are kept in " + aside->string() + ".";
    }
    return Done{};
}

void show_report(Ui& ui, const fs::path& file) {
    constexpr std::size_t kMostBytes = 1 << 16;
    const Expected<std::string> text = read_text_file(file, kMostBytes);
    tell(ui, file.filename().string(), text ? *text : text.error().message);
}

}  // namespace

void tell_of_start(App& app) {
    std::string text;
    for (const std::string& remark : app.work.session.remarks) {
        text += (text.empty() ? "" : " ") + with_stop(remark);
    }
    const std::vector<fs::path>& recovered = app.work.session.recovered;
    for (const fs::path& file : recovered) {
        text += std::string(text.empty() ? "" : " ") +
                "Unsaved changes of a window that did not end as it should are kept in " +
                file.string() + ".";
    }
    const std::optional<fs::path>& report = app.work.session.crash_report;
    if (report) {
        text += std::string(text.empty() ? "" : " ") +
                "The program crashed. What is known of it, " + "and nothing of your sets, is in " +
                report->string() + ".";
    }
    if (text.empty()) return;
    std::vector<Answer> answers;
    if (recovered.size() == 1) {
        answers.push_back({"Open them", [&app, file = recovered[0]] { open_file(app, file); }});
    }
    if (report) {
        answers.push_back(
            {"Show the report", [&app, file = *report] { show_report(app.ui, file); }});
    }
    if (answers.empty()) return tell(app.ui, "Before you begin", text);
    answers.push_back({"Not now"});
    ask(app.ui, {.title = "Before you begin",
                 .text = text,
                 .answers = answers,
                 .marked = answers.size() - 1});
}

Expected<Done> start_session(App& app, const std::vector<std::filesystem::path>& paths) {
    app.work.session = open_session(state_folder());
    app.ui.dismissed_hints = app.work.session.dismissed_hints;
    app.ui.dark = app.work.session.theme != "light";
    app.lesson.language = app.work.session.lesson_language;
    app.ui.text_scale = std::clamp(static_cast<float>(app.work.session.text_scale), 0.75F, 2.0F);
    restore_layout(app);
    app.of_document = 0;  // the restored views belong to the document that follows
    restore_devices(app.work, app.play);
    if (paths.size() == 1 && is_lesson_file(paths[0])) {
        take_up_session(app);
        set_last_lesson_aside(app);
        open_lesson(lesson_context(app), app.lesson, paths[0]);
        if (!app.lesson.step) return Error{app.ui.status.text};
    } else if (paths.size() == 1 && is_course_file(paths[0])) {
        take_up_session(app);
        take_up_lesson(app);
        open_course_file(app.ui, app.work.session, app.course, paths[0]);
        if (!app.course.course) return Error{app.ui.status.text};
    } else if (paths.empty()) {
        take_up_session(app);
        take_up_lesson(app);
    } else {
        set_last_lesson_aside(app);
        if (const Expected<Done> opened = open_instead(app, paths); !opened) return opened.error();
    }
    tell_of_start(app);
    return Done{};
}

void keep_layout(App& app) {
    auto& kept = app.work.session.layout;
    app.work.session.lesson_steps = places_left(app.lesson);
    keep_workspaces(app.layout, app.workspaces, kept);
    kept["yaw_rad"] = app.shown_map.camera.yaw_rad;
    kept["pitch_rad"] = app.shown_map.camera.pitch_rad;
    kept["zoom"] = app.shown_map.camera.zoom;
    kept["dimensions"] = app.shown_map.dimensions;
    kept["card_side"] = static_cast<double>(app.lesson.dock);
    kept["card_share"] = static_cast<double>(app.lesson.card_share);
    kept["present_scale"] = static_cast<double>(app.lesson.present_scale);
    kept["strip_height"] = static_cast<double>(app.pattern_panes.strip.height);
    kept["own_heights"] = app.work.own_heights ? 1.0 : 0.0;
    kept["textbook"] = app.physiology.view.textbook ? 1.0 : 0.0;
    kept["motion"] = app.ui.motion ? 1.0 : 0.0;
}

void restore_layout(App& app) {
    const auto& kept = app.work.session.layout;
    const auto value = [&kept](const char* name, double low, double high, double otherwise) {
        const auto found = kept.find(name);
        return found == kept.end() ? otherwise : std::clamp(found->second, low, high);
    };
    const auto share = [&](const char* name, float low, float high, float& target) {
        target = static_cast<float>(value(name, static_cast<double>(low), static_cast<double>(high),
                                          static_cast<double>(target)));
    };
    restore_workspaces(kept, app.layout, app.workspaces);
    app.shown_map.camera.yaw_rad = value("yaw_rad", -10.0, 10.0, app.shown_map.camera.yaw_rad);
    app.shown_map.camera.pitch_rad = value("pitch_rad", -1.6, 1.6, app.shown_map.camera.pitch_rad);
    app.shown_map.camera.zoom = value("zoom", kLeastZoom, kMostZoom, app.shown_map.camera.zoom);
    app.shown_map.dimensions = value("dimensions", 2.0, 3.0, 3.0) < 2.5 ? 2 : 3;
    app.lesson.left_at = app.work.session.lesson_steps;
    app.lesson.dock = static_cast<DockSide>(static_cast<int>(value("card_side", 0.0, 3.0, 0.0)));
    share("card_share", 0.15F, 0.5F, app.lesson.card_share);
    share("present_scale", 1.0F, 3.0F, app.lesson.present_scale);
    float& strip_height = app.pattern_panes.strip.height;
    strip_height = static_cast<float>(value("strip_height", kStripHeight.low, kStripHeight.high,
                                            static_cast<double>(strip_height)));
    app.work.own_heights = value("own_heights", 0.0, 1.0, 0.0) > 0.5;
    app.physiology.view.textbook = value("textbook", 0.0, 1.0, 0.0) > 0.5;
    app.ui.motion = value("motion", 0.0, 1.0, 1.0) > 0.5;
}

Expected<Done> keep_before_end(App& app) {
    const Expected<Done> lesson = keep_lesson(app.work, app.lesson);
    const Expected<Done> document = keep_document(app);
    return lesson ? document : lesson;
}

namespace {

void ask_of_lesson(App& app, const std::string& reason) {
    const auto discard = [&app] {
        let_lesson_go(app.lesson);
        quit(app);
    };
    ask(app.ui,
        {.title = "Unsaved lesson",
         .text = "What was written in \"" + app.lesson.lesson->name +
                 "\" cannot be kept for the next start, and would be lost. " + with_stop(reason),
         .answers = {{"Save as...", [&app] { save_lesson_dialog(app.ui, app.work, app.lesson); }},
                     {"Discard and quit", discard},
                     {"Cancel"}}});
}

// Saving applies to the person's document, not to the lesson's set: the lesson ends first.
void save_own(App& app) {
    if (app.lesson.aside && !leave_lesson(lesson_context(app), app.lesson)) return;
    save(app.ui, app.work);
}

// Once for each person, as for the document.
bool tells_of_lesson(App& app) {
    constexpr const char* kTold = "quit keeps the lesson";
    if (!unsaved_lesson(app.work, app.lesson) || app.ui.dismissed_hints.contains(kTold))
        return false;
    const auto leave = [&app] {
        app.ui.dismissed_hints.insert(kTold);
        app.ui.quit = true;
    };
    ask(app.ui,
        {.title = "The lesson is kept",
         .text = "What was written in \"" + app.lesson.lesson->name +
                 "\" is kept, and is here again at the next start. It is in no file: that takes "
                 "Save. You will not be told again.",
         .answers = {{"Quit", leave},
                     {"Save as...", [&app] { save_lesson_dialog(app.ui, app.work, app.lesson); }},
                     {"Cancel"}}});
    return true;
}

}  // namespace

bool may_close(App& app) {
    if (is_study_running(app.studying)) leave_study(app);
    const Expected<Done> lesson = keep_lesson(app.work, app.lesson);
    if (!lesson && unsaved_lesson(app.work, app.lesson)) {
        ask_of_lesson(app, lesson.error().message);
        return false;
    }
    const Expected<Done> kept = keep_document(app);
    if (kept) return true;
    end_lesson(app);
    ask(app.ui, {.title = "Unsaved changes",
                 .text = "The unsaved changes of \"" + document_name(app.work) +
                         "\" cannot be kept for the next start, and would be lost. " +
                         with_stop(kept.error().message),
                 .answers = {{"Save as...", [&app] { save_dialog(app.ui, app.work); }},
                             {"Discard and quit", [&app] { discard_and_quit(app); }},
                             {"Cancel"}}});
    return false;
}

// Once for each person: a person who knows it is not asked again.
bool tells_what_is_kept(App& app) {
    constexpr const char* kTold = "quit keeps what is unsaved";
    const EditedDocument& own = own_document(app);
    if (own.set == own.saved || app.ui.dismissed_hints.contains(kTold)) return false;
    const auto leave = [&app] {
        app.ui.dismissed_hints.insert(kTold);
        app.ui.quit = true;
    };
    ask(app.ui, {.title = "Unsaved changes are kept",
                 .text = "The changes of " +
                         (app.lesson.aside ? "the set" : "\"" + document_name(app.work) + "\"") +
                         " are kept, and are here again at the next start. They are not in its "
                         "file: that takes Save. You will not be told again.",
                 .answers = {{"Quit", leave}, {"Save...", [&app] { save_own(app); }}, {"Cancel"}}});
    return true;
}

bool close_window(App& app) {
    return may_close(app) && !tells_of_lesson(app) && !tells_what_is_kept(app);
}

void quit(App& app) {
    if (close_window(app)) app.ui.quit = true;
}

void end_session(App& app) {
    (void)keep_lesson(app.work, app.lesson);
    end_lesson(app);
    app.work.session.theme = app.ui.dark ? "dark" : "light";
    app.work.session.lesson_language = app.lesson.language;
    app.work.session.dismissed_hints = app.ui.dismissed_hints;
    app.work.session.text_scale = static_cast<double>(app.ui.text_scale);
    app.work.session.document = app.work.document.path;
    keep_layout(app);
    keep_devices(app.work, app.play);
    // A status line would not be read; the next start reports the error.
    wait_for_autosave(app.work);
    (void)autosave(app.work.session, app.work.document.kept());
    (void)close_session(app.work.session);
}

}  // namespace tact
