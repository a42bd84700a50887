// Participants stay with the set that they rated, whatever happens to its file.

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/study/study.h"
#include "model/io/people/study_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace study_place_test {

using namespace tact;

namespace {

// A set without a file, rated by somebody.
struct Rated : Program {
    TemporaryFolder folder;

    Rated() : Program(short_patterns(4)) {
        app.work.session = open_session(folder.path / "state");
        std::filesystem::create_directories(study_folder(app.work, app.studying));
        StudyRecord record;
        record.header = study_header(app.work, app.play, app.studying, "P1");
        REQUIRE(write_study_file(study_folder(app.work, app.studying) / "P1.jsonl", record));
    }
    ~Rated() { (void)close_session(app.work.session); }
    bool sees_participant() const { return contains_study(study_folder(app.work, app.studying)); }
};

}  // namespace

TEST_CASE("participants: saving a set that had no file takes them along, and says so") {
    Rated program;
    App& app = program.app;
    const auto before = study_folder(app.work, app.studying);
    save_as(app.ui, app.work, program.folder.path / "mine.tactspace.json");
    follow_changes(app);
    CHECK(study_folder(app.work, app.studying) == program.folder.path / "mine study");
    CHECK(program.sees_participant());
    CHECK_FALSE(std::filesystem::exists(before));
    CHECK(contains(app.ui.status.text, "Its participants are now in"));
    // As the next start finds them.
    open_paths(app.ui, app.work, app.opening, {program.folder.path / "mine.tactspace.json"});
    CHECK(program.sees_participant());
}

TEST_CASE("participants: where others are in the way, nobody is mixed up and all stay in sight") {
    Rated program;
    App& app = program.app;
    const auto before = study_folder(app.work, app.studying);
    const auto others = program.folder.path / "mine study";
    std::filesystem::create_directories(others);
    save_as(app.ui, app.work, program.folder.path / "mine.tactspace.json");
    follow_changes(app);
    CHECK(study_folder(app.work, app.studying) == before);
    CHECK(program.sees_participant());
    CHECK(std::filesystem::is_empty(others));
    CHECK(contains(app.ui.status.text, "Its participants stay in"));
}

TEST_CASE("participants: of a saved set, they stay with its file and in sight of the copy") {
    Rated program;
    App& app = program.app;
    save_as(app.ui, app.work, program.folder.path / "mine.tactspace.json");
    follow_changes(app);
    save_as(app.ui, app.work, program.folder.path / "copy.tactspace.json");
    follow_changes(app);
    CHECK(contains_study(program.folder.path / "mine study"));
    CHECK(program.sees_participant());
    CHECK(contains(app.ui.status.text, "Its participants stay in"));
    // A document that is opened next has no participants.
    new_document(app.ui, app.work);
    CHECK_FALSE(program.sees_participant());
}

TEST_CASE("participants: a set that was put aside and opened again still has its own") {
    Rated program;
    App& app = program.app;
    app.work.document.edit().duration_s = 0.2;
    new_document(app.ui, app.work);
    REQUIRE_FALSE(app.work.session.recent_files.empty());
    open_paths(app.ui, app.work, app.opening, {app.work.session.recent_files[0]});
    CHECK(app.work.document.set.vibrations.size() == 4);
    CHECK(program.sees_participant());
}

TEST_CASE("participants: of a set with a name that no file can have, they have a folder") {
    Program program(short_patterns(2));
    TemporaryFolder folder;
    App& app = program.app;
    app.work.session.folder = folder.path;
    std::string longest;
    for (int k = 0; k < 300; ++k) longest += "\u89e6";
    for (const std::string& name : {longest, std::string("a/b: c?"), std::string("..")}) {
        app.work.document.edit().name = name;
        const auto place = study_folder(app.work, app.studying);
        std::error_code fault;
        std::filesystem::create_directories(place, fault);
        CHECK_MESSAGE(!fault, name);
        CHECK(place.parent_path() == folder.path / "studies");
    }
}

}  // namespace study_place_test
