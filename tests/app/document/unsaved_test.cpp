// What somebody made is never lost to another document, to closing the window, or to a save.

#include "app/document/editing.h"

#include "app/opening/opening.h"
#include "app/session/session.h"
#include "app/window/window.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "tests/support/no_more_than.h"
#include "tests/support/program.h"
#include "tests/support/state_home.h"
#include "tests/support/temporary_folder.h"

namespace unsaved_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// A session that was begun in a folder of its own, with one change that is not saved.
struct Edited : Program {
    TemporaryFolder folder;

    Edited() : Program(short_patterns(3)) {
        app.work.session = open_session(folder.path / "state");
        edit();
    }
    ~Edited() { (void)close_session(app.work.session); }
    void edit() {
        app.work.selection.current = 0;
        edit_patterns(app.work, [](Pattern& pattern) { pattern.amplitude_g += 0.1; });
        commit_step(app.ui, app.work, "amplitude");
    }
    // No room for a byte more, wherever it looks.
    void fill_disk() {
        app.work.session.autosave = app.work.session.folder / "full";
        fs::create_symlink("/dev/full", app.work.session.autosave);
    }
    // It is there, but nothing can be written into it, by root either.
    void lock_folder() {
        app.work.session.folder = "/proc/self";
        app.work.session.autosave = "/proc/self/autosave.json";
    }
};

bool refuses_others(Program& program) {
    App& app = program.app;
    const PatternSet edited = app.work.document.set;
    for (const auto replace : {new_document, open_example}) {
        app.ui.status = {};
        replace(app.ui, app.work);
        if (!app.ui.status.is_error || !contains(app.ui.status.text, "Save as...")) return false;
        if (app.work.document.set != edited || app.work.document.history.undo_label() == nullptr)
            return false;
    }
    return true;
}

}  // namespace

TEST_CASE("unsaved: an autosave is of the set as it was, and a frame goes on meanwhile") {
    Edited program;
    App& app = program.app;
    const fs::path file = app.work.session.autosave;
    while (!is_autosaving(app.work)) program.frame();
    const PatternSet as_it_was = app.work.document.set;
    edit_patterns(app.work, [](Pattern& pattern) { pattern.amplitude_g = 3.0; });  // a drag
                                                                                   // continues
    wait_for_autosave(app.work);
    Session later = app.work.session;
    const Restored restored = restore(later);
    REQUIRE(restored.document);
    CHECK(restored.document->set == as_it_was);
    CHECK(app.work.document.set != as_it_was);
}

TEST_CASE("unsaved: what is kept at the end comes after the autosave that was under way") {
    Edited program;
    App& app = program.app;
    while (!is_autosaving(app.work)) program.frame();
    program.edit();
    REQUIRE(may_close(app));
    Session later = app.work.session;
    const Restored restored = restore(later);
    REQUIRE(restored.document);
    CHECK(restored.document->set == app.work.document.set);
}

TEST_CASE(
    "unsaved: a crash right after a save brings back what was saved, not what was kept before") {
    Edited program;
    App& app = program.app;
    while (!is_autosaving(app.work)) program.frame();
    program.edit();
    save_as(app.ui, app.work, program.folder.path / "mine.tactspace.json");
    REQUIRE_FALSE(app.ui.status.is_error);
    Session later = app.work.session;
    later.document = app.work.document.path;
    const Restored restored = restore(later);
    REQUIRE(restored.document);
    CHECK(restored.document->set == app.work.document.set);
    CHECK(restored.document->set == restored.document->saved);
}

TEST_CASE("unsaved: an autosave that the disk has no room for is told once it has failed") {
    Edited program;
    App& app = program.app;
    program.lock_folder();
    while (app.work.autosave_error.empty()) program.frame();
    CHECK(app.ui.status.is_error);
    CHECK(contains(app.ui.status.text, "Unsaved changes cannot be kept aside"));
}

TEST_CASE("unsaved: with a file where the state folder should be, no document takes its place") {
    const TemporaryFolder folder;
    const StateHome home(folder.write("a file", ""));
    Program program(short_patterns(3));
    App& app = program.app;
    REQUIRE(start_session(app, {}));
    program.settle();
    // And it is said before anything is made.
    CHECK(contains(program.at("question").value, "Nothing will be kept after this run"));
    program.press_key(key::kEnter);
    CHECK_FALSE(program.shows("question"));
    new_document(app.ui, app.work);
    CHECK(app.work.document.set.vibrations.empty());  // nothing was unsaved
    add_pattern(app.ui, app.work);
    CHECK(refuses_others(program));
    // Saved, it may go.
    save_as(app.ui, app.work, folder.path / "mine.tactspace.json");
    new_document(app.ui, app.work);
    CHECK(app.work.document.set.vibrations.empty());
}

TEST_CASE("unsaved: in a folder that cannot be written, and on a full disk, it stays as well") {
    for (const bool is_full : {true, false}) {
        Edited program;
        is_full ? program.fill_disk() : program.lock_folder();
        CHECK(refuses_others(program));
        const fs::path other = program.folder.path / "other.tactspace.json";
        REQUIRE(write_set_file(other, short_patterns(2)));
        open_paths(program.app.ui, program.app.work, program.app.opening, {other});
        CHECK(program.app.work.document.set.vibrations.size() == 3);
        CHECK(program.app.work.session.recent_files.empty());
    }
}

TEST_CASE("unsaved: it is kept aside where it can be, and the other document opens") {
    Edited program;
    App& app = program.app;
    const PatternSet edited = app.work.document.set;
    open_example(app.ui, app.work);
    CHECK(app.work.document.set.vibrations.size() == 12);
    REQUIRE(app.work.session.recent_files.size() == 1);
    const auto kept = load_set(app.work.session.recent_files[0]);
    REQUIRE(kept);
    CHECK(kept->set == edited);
}

TEST_CASE("unsaved: a window with the only copy stays open and asks") {
    Edited program;
    App& app = program.app;
    CHECK(may_close(app));  // kept for the next start
    program.fill_disk();
    CHECK_FALSE(may_close(app));
    program.settle();
    CHECK(contains(program.at("question").value, "No space left on device"));
    CHECK(program.at("answer:Save as...").value == "marked");
    // Esc changes nothing, and the next try asks again.
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("question"));
    CHECK_FALSE(app.ui.quit);
    program.press('q', true);
    CHECK(program.shows("question"));
    CHECK_FALSE(app.ui.quit);
    // Enter takes the marked answer: where to?
    program.press_key(key::kEnter);
    CHECK(app.ui.chooser.is_open);
    CHECK(app.ui.chooser.title == "Save the set");
    program.press_key(key::kEscape);
    save_as(app.ui, app.work, program.folder.path / "mine.tactspace.json");
    CHECK(may_close(app));
}

TEST_CASE("unsaved: who quits is told once that changes are kept, and may stay or save") {
    Edited program;
    App& app = program.app;
    program.press('q', true);
    CHECK(contains(program.at("question").value, "are kept"));
    program.press_key(key::kEscape);
    CHECK_FALSE(app.ui.quit);
    program.press('q', true);
    program.press_key(key::kEnter);
    CHECK(app.ui.quit);
    // From then on it just ends.
    app.ui.quit = false;
    program.press('q', true);
    CHECK_FALSE(program.shows("question"));
    CHECK(app.ui.quit);
}

TEST_CASE("unsaved: only the word to discard discards, by keyboard too") {
    Edited program;
    program.fill_disk();
    program.press('q', true);
    program.press_key(key::kRight);
    CHECK(program.at("answer:Discard and quit").value == "marked");
    CHECK_FALSE(program.app.ui.quit);
    program.press_key(key::kEnter);
    CHECK(program.app.ui.quit);
}

TEST_CASE("unsaved: while a question is open, no command and no drop reaches the document") {
    Edited program;
    App& app = program.app;
    program.fill_disk();
    program.press('q', true);
    const PatternSet edited = app.work.document.set;
    program.press('n', true);
    program.press_key(key::kDelete);
    CHECK(app.work.document.set == edited);
    program.click("answer:Cancel");
    CHECK_FALSE(program.shows("question"));
    program.press('n', true);
    CHECK(app.work.document.set.vibrations.size() == 4);
}

TEST_CASE("unsaved: a full disk does not cost what the last session left, when a file is opened") {
    const TemporaryFolder folder;
    const StateHome home(folder.path / "state");
    const fs::path other = folder.path / "other.tactspace.json";
    REQUIRE(write_set_file(other, short_patterns(2)));
    {
        Session session = open_session(state_folder());
        REQUIRE(autosave(session, {short_patterns(5), {}, {}}));
        (void)close_session(session);
    }
    Program program(short_patterns(1));
    App& app = program.app;
    {
        const NoMoreThan full(0);
        REQUIRE(start_session(app, {other}));
    }
    CHECK(app.work.document.set.vibrations.size() == 5);
    CHECK(contains(app.ui.status.text, "This document stays open"));
    open_paths(app.ui, app.work, app.opening, {other});  // there is room again
    CHECK(app.work.document.set.vibrations.size() == 2);
    CHECK(contains(app.ui.status.text, "Unsaved changes before it are kept in"));
    (void)close_session(app.work.session);
}

TEST_CASE("save: what another program wrote since is not written over without a word") {
    Edited program;
    App& app = program.app;
    const fs::path file = program.folder.path / "mine.tactspace.json";
    save_as(app.ui, app.work, file);
    program.edit();
    save(app.ui, app.work);
    program.settle();
    CHECK_FALSE(program.shows("question"));  // what was written here is known here
    PatternSet outside = app.work.document.set;
    outside.name = "by another";
    REQUIRE(write_set_file(file, outside));
    program.edit();
    program.press('s', true);
    CHECK(contains(program.at("question").value, "has been changed since it was opened here"));
    CHECK(load_set(file)->set.name == "by another");
    program.press_key(key::kEscape);
    CHECK(load_set(file)->set.name == "by another");
    // Elsewhere it never asks.
    save_as(app.ui, app.work, program.folder.path / "elsewhere.tactspace.json");
    program.settle();
    CHECK_FALSE(program.shows("question"));
}

TEST_CASE("save: who says so writes over it, and is not asked again") {
    Edited program;
    App& app = program.app;
    const fs::path file = program.folder.path / "mine.tactspace.json";
    REQUIRE(write_set_file(file, short_patterns(3)));
    new_document(app.ui, app.work);
    open_paths(app.ui, app.work, app.opening, {file});
    REQUIRE(write_set_file(file, short_patterns(2)));
    program.edit();
    program.press('s', true);
    program.click("answer:Overwrite");
    CHECK(load_set(file)->set == app.work.document.set);
    CHECK_FALSE(is_changed_outside(app.work.document.kept(), file));
    // Not there any more: nothing is lost by writing it.
    fs::remove(file);
    program.edit();
    program.press('s', true);
    CHECK(load_set(file)->set == app.work.document.set);
}

TEST_CASE("save: a change from outside is noticed after a recovery, too") {
    Edited program;
    App& app = program.app;
    const fs::path file = program.folder.path / "mine.tactspace.json";
    save_as(app.ui, app.work, file);
    program.edit();
    REQUIRE(autosave(app.work.session, app.work.document.kept()));
    REQUIRE(write_set_file(file, short_patterns(2)));
    const Restored restored = restore(app.work.session);
    REQUIRE(restored.document);
    CHECK(is_changed_outside(*restored.document, file));
}

TEST_CASE("open: that another window has the document open is said, until that one lets go") {
    Edited first;
    Program second(short_patterns(1));
    second.app.work.session = open_session(first.folder.path / "state");
    const fs::path file = first.folder.path / "mine.tactspace.json";
    save_as(first.app.ui, first.app.work, file);
    open_paths(second.app.ui, second.app.work, second.app.opening, {file});
    CHECK(contains(second.app.ui.status.text, "open in another window"));
    open_paths(second.app.ui, second.app.work, second.app.opening, {file});  // itself is no other
    CHECK(contains(second.app.ui.status.text, "open in another window"));
    new_document(first.app.ui, first.app.work);
    open_paths(second.app.ui, second.app.work, second.app.opening, {file});
    CHECK_FALSE(contains(second.app.ui.status.text, "another window"));
    open_paths(first.app.ui, first.app.work, first.app.opening, {file});
    CHECK(contains(first.app.ui.status.text, "open in another window"));
    (void)close_session(second.app.work.session);
    open_paths(first.app.ui, first.app.work, first.app.opening, {file});
    CHECK_FALSE(contains(first.app.ui.status.text, "another window"));
}

TEST_CASE("start: what was wrong with the settings, and what was recovered, reaches the person") {
    const TemporaryFolder folder;
    const StateHome home(folder.path / "state");
    folder.write("state/tactspace/session.json", "{ damaged");
    {
        const FileLock first = *try_lock(state_folder() / "lock");
        Session second = open_session(state_folder());
        REQUIRE_FALSE(second.is_first);
        REQUIRE(autosave(second, {short_patterns(5), {}, {}}));
    }
    Program program(short_patterns(1));
    REQUIRE(start_session(program.app, {}));
    program.settle();
    const std::string said = program.at("question").value;
    CHECK(contains(said, "The settings could not be read"));
    CHECK(contains(said, "did not end as it should are kept in"));
    CHECK(contains(said, "recovered-"));
    program.click("answer:Open them");
    CHECK(program.app.work.document.set.vibrations.size() == 5);
    (void)close_session(program.app.work.session);
}

}  // namespace unsaved_test
