// The history owns the document: undo, redo, saving and the map's turn agree with each other.
#include "app/document/workspace.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <type_traits>
#include <utility>

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/session/session.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace edited_document_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

template <class Value>
concept writable = requires(Workspace& work, Value value) {
    work.document.set = value;
};
static_assert(!writable<PatternSet>, "the set is changed by edit() alone");
static_assert(
    std::is_const_v<std::remove_reference_t<decltype(std::declval<Workspace&>().document.path)>>);

std::string bytes_of(const fs::path& file) {
    const auto text = read_text_file(file);
    REQUIRE(text);
    return *text;
}

// A set file with a window on it.
struct Opened : Program {
    TemporaryFolder folder;
    fs::path file = folder.path / "mine.tactspace.json";

    explicit Opened(const PatternSet& set) : Program({}) {
        REQUIRE(write_set_file(file, set));
        open_paths(app.ui, app.work, app.opening, {file});
        settle();
    }
    void undo_all() {
        while (app.work.document.history.undo_label() != nullptr) undo(app.ui, app.work);
        settle();
    }
    std::string saved() {
        save(app.ui, app.work);
        settle();
        return bytes_of(file);
    }
    bool is_marked() {
        settle();
        return app.work.unsaved;
    }
};

PatternSet nameless() {
    PatternSet set = short_patterns(3);
    set.name.clear();
    return set;
}

Vibration recording_of(const std::string& path) {
    Vibration vibration;
    vibration.name = "recorded";
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(render(Pattern{}));
    measurement.path = path;
    vibration.source = measurement;
    return vibration;
}

std::string path_of(const PatternSet& set, const std::string& name) {
    return std::get<Measurement>(set.vibrations[*place_named(set, name)].source).path;
}

}  // namespace

TEST_CASE("document: undo to the last save is the saved document, of a set without a name too") {
    Opened program(nameless());
    App& app = program.app;
    add_pattern(app.ui, app.work);
    CHECK(program.is_marked());
    program.saved();
    CHECK_FALSE(program.is_marked());
    duplicate_selected(app.ui, app.work);
    CHECK(program.is_marked());
    undo(app.ui, app.work);
    CHECK_FALSE(program.is_marked());
    CHECK(document_title(app.work) == "mine.tactspace.json");
}

TEST_CASE("document: the name that the first save gives is no step of undo, and stays after one") {
    Program program({});
    const TemporaryFolder folder;
    App& app = program.app;
    add_pattern(app.ui, app.work);
    save_as(app.ui, app.work, folder.path / "fresh.tactspace.json");
    CHECK(app.work.document.set.name == "fresh");
    add_pattern(app.ui, app.work);
    undo(app.ui, app.work);
    program.settle();
    CHECK(app.work.document.set.name == "fresh");
    CHECK_FALSE(app.work.unsaved);
    undo(app.ui, app.work);
    CHECK(app.work.document.set.vibrations.empty());
    CHECK(app.work.document.set.name == "fresh");
    redo(app.ui, app.work);
    program.settle();
    CHECK_FALSE(app.work.unsaved);
}

TEST_CASE("document: a save moves the files of recordings in every state that undo can reach") {
    Program program(short_patterns(2));
    const TemporaryFolder folder;
    App& app = program.app;
    app.work.session = open_session(folder.path / "state");
    const fs::path kept = measured_folder(app.work.session);
    add_vibrations(app.ui, app.work, {recording_of((kept / "a.wav").string())}, "Add");
    app.work.selection.current = 0;
    edit_patterns(app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.3; });
    commit_step(app.ui, app.work, "amplitude");
    save_as(app.ui, app.work, folder.path / "mine.tactspace.json");
    const std::string moved = path_of(app.work.document.set, "recorded");
    CHECK(fs::path(moved).parent_path() == folder.path / "measured");
    undo(app.ui, app.work);
    CHECK(path_of(app.work.document.set, "recorded") == moved);
    redo(app.ui, app.work);
    program.settle();
    CHECK_FALSE(app.work.unsaved);
    (void)close_session(app.work.session);
}

TEST_CASE("document: undo of everything and a save give the bytes of the first file, map and all") {
    Opened program(short_patterns(5));
    App& app = program.app;
    program.compute_map();
    add_pattern(app.ui, app.work);
    program.wait_for_exact_map();
    const std::string first = program.saved();
    const auto places = app.shown_map.transition.to;
    for (const double amplitude_g : {0.2, 2.0}) {
        app.work.selection.current = 2;
        edit_patterns(app.work, [&](Pattern& pattern) {
            pattern.amplitude_g = amplitude_g;
            pattern.carriers[0].frequency_hz = 300.0;
        });
        commit_step(app.ui, app.work, "amplitude");
        program.wait_for_exact_map();
        CHECK(program.saved() != first);
    }
    const std::string last = bytes_of(program.file);
    undo(app.ui, app.work);
    undo(app.ui, app.work);
    program.wait_for_exact_map();
    CHECK((app.shown_map.transition.to - places).norm() < 1e-3 * places.norm());
    CHECK(program.saved() == first);
    redo(app.ui, app.work);
    redo(app.ui, app.work);
    program.wait_for_exact_map();
    CHECK(program.saved() == last);
    program.undo_all();
    program.wait_for_exact_map();
    program.saved();
    CHECK(load_set(program.file)->set == short_patterns(5));
}

TEST_CASE("document: a file has the places of exactly its own patterns, or none") {
    Opened program(short_patterns(5));
    App& app = program.app;
    program.compute_map();
    add_pattern(app.ui, app.work);
    program.wait_for_exact_map();
    program.saved();
    CHECK(load_set(program.file)->set.map_places.at.size() == 6);
    // Saved at once, before there is a map of it: in a rename, too, whose names are others.
    rename_vibration(app.ui, app.work, 0, "another");
    save(app.ui, app.work);
    CHECK(load_set(program.file)->set.map_places.at.empty());
    // What was saved stays as it was saved: the mark and the bytes agree.
    program.wait_for_exact_map();
    const std::string file = bytes_of(program.file);
    CHECK_FALSE(program.is_marked());
    CHECK(program.saved() == file);
}

TEST_CASE("document: a set that was only opened is saved as it was, whatever its map does") {
    Opened program(short_patterns(4));
    const std::string before = bytes_of(program.file);
    program.compute_map();
    program.settle();
    CHECK(program.saved() == before);
}

TEST_CASE("document: a change that nobody made a step of is none that undo loses") {
    Program program(short_patterns(2));
    App& app = program.app;
    app.work.document.edit().vibrations[0].note = "in the middle of a gesture";
    undo(app.ui, app.work);
    CHECK(app.work.document.set == short_patterns(2));
    redo(app.ui, app.work);
    CHECK(app.work.document.set.vibrations[0].note == "in the middle of a gesture");
}

TEST_CASE("document: a copy reads its own values, and so does what was moved") {
    EditedDocument document;
    document.open({short_patterns(2), {}, short_patterns(2)});
    EditedDocument copy = document;
    copy.edit().name = "copy";
    CHECK(copy.set.name == "copy");
    CHECK(document.set.name == "test");
    EditedDocument moved = std::move(copy);
    CHECK(moved.set.name == "copy");
    document = std::move(moved);
    CHECK(document.set.name == "copy");
    CHECK(document.commit("Rename"));
    CHECK(document.undo());
    CHECK(document.set.name == "test");
}

}  // namespace edited_document_test
