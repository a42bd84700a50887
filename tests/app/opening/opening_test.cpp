// Files are read in the background: a frame never waits for one, and what was read comes only where
// it was asked for.
#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/window/window.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace opening_test {

using namespace tact;

namespace {

// Reading that takes as long as a test wants.
struct SlowDisk {
    TemporaryFolder folder;
    Program program{short_patterns(2)};
    std::shared_ptr<std::atomic<bool>> is_read = std::make_shared<std::atomic<bool>>(false);
    App& app = program.app;

    SlowDisk() {
        begin_jobs(app);
        app.opening.job.begin(
            [is_read = is_read](const OpeningRequest& request, const std::stop_token& stop,
                                std::atomic<float>& progress) -> std::optional<OpeningAnswer> {
                progress = 0.4F;
                while (!*is_read && !stop.stop_requested()) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                if (stop.stop_requested()) return {};
                LoadOptions options;
                options.partly = request.partly;
                return OpeningAnswer{
                    request, std::make_shared<Expected<Loaded>>(load_sets(request.paths, options))};
            });
    }

    std::filesystem::path set_of(std::size_t count) {
        const auto file = folder.path / (std::to_string(count) + ".tactspace.json");
        REQUIRE(write_set_file(file, short_patterns(count)));
        return file;
    }
    void open(const std::filesystem::path& file) {
        open_paths(app.ui, app.work, app.opening, {file});
    }
    void add(const std::filesystem::path& file) {
        add_paths(app.ui, app.work, app.opening, {file});
    }
    void end_reading() {
        *is_read = true;
        program.wait_for_opening();
    }
    std::size_t count() const { return app.work.document.set.vibrations.size(); }
    // Until the disk is being read.
    void wait_for_reader() {
        wait_until(program, [this] { return app.opening.job.progress() > 0.0F; });
    }
    // So long that it is said.
    void rest() {
        for (int k = 0; k < 30; ++k) program.frame();
    }
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("opening: frames go on while a file is read, which says how far it is") {
    SlowDisk disk;
    disk.open(disk.set_of(5));
    disk.program.frame();
    CHECK_FALSE(disk.program.shows("progress:reading"));  // most files need no word
    disk.wait_for_reader();
    disk.rest();
    CHECK(disk.count() == 2);
    CHECK(disk.program.at("progress:reading").value == "Reading 5.tactspace.json, 40 %");
    disk.end_reading();
    CHECK(disk.count() == 5);
    CHECK(disk.app.ui.status.text == "Opened 5 patterns.");
    CHECK_FALSE(disk.program.shows("progress:reading"));
}

TEST_CASE("opening: Esc and the link cancel it, and the document stays") {
    for (const bool by_key : {true, false}) {
        CAPTURE(by_key);
        SlowDisk disk;
        disk.open(disk.set_of(5));
        disk.rest();
        by_key ? disk.program.press_key(key::kEscape) : disk.program.click("link:cancel reading");
        CHECK_FALSE(is_opening(disk.app.opening));
        CHECK(disk.app.ui.status.text == "Nothing was opened: reading was cancelled.");
        *disk.is_read = true;
        disk.rest();
        CHECK(disk.count() == 2);
    }
}

TEST_CASE("opening: the file that was asked for last is the one that is shown") {
    SlowDisk disk;
    disk.open(disk.set_of(5));
    disk.program.frame();
    disk.open(disk.set_of(3));
    disk.end_reading();
    disk.rest();
    CHECK(disk.count() == 3);
    CHECK(disk.app.work.document.path.filename() == "3.tactspace.json");
}

TEST_CASE("opening: while a file is read none is added") {
    SlowDisk disk;
    disk.open(disk.set_of(5));
    disk.add(disk.set_of(3));
    CHECK(disk.app.ui.status.is_error);
    CHECK(has(disk.app.ui.status.text, "5.tactspace.json is still being read"));
    disk.end_reading();
    CHECK(disk.count() == 5);
}

TEST_CASE("opening: what was read waits for a question, a dialog, a list and a hand") {
    SlowDisk disk;
    App& app = disk.app;
    const auto stays = [&] {
        *disk.is_read = true;
        while (app.opening.job.busy()) disk.program.frame();
        disk.rest();
        return disk.count() == 2;
    };
    disk.open(disk.set_of(5));
    tell(app.ui, "A question", "Is it?");
    CHECK(stays());
    app.ui.question.reset();
    app.ui.dialog = kGenerateDialog;
    CHECK(stays());
    app.ui.dialog = kNoDialog;
    disk.program.settle();
    disk.program.wait_for_opening();
    CHECK(disk.count() == 5);
}

TEST_CASE("opening: patterns are added to the set that they were read for, and to no other") {
    SlowDisk disk;
    disk.add(disk.set_of(3));
    new_document(disk.app.ui, disk.app.work);
    disk.program.settle();
    disk.end_reading();
    CHECK(disk.count() == 0);
    CHECK(disk.app.ui.status.is_error);
    CHECK(has(disk.app.ui.status.text, "the set it was for is not open any more"));
    disk.add(disk.folder.path / "3.tactspace.json");
    disk.end_reading();
    CHECK(disk.count() == 3);
}

TEST_CASE("opening: of several files the bad ones are left out, and named on request") {
    Program program(short_patterns(2));
    App& app = program.app;
    begin_jobs(app);
    const TemporaryFolder folder;
    REQUIRE(write_set_file(folder.path / "good.tactspace.json", short_patterns(4)));
    folder.write("bad.ahap", "{");
    drop_paths(app, {folder.path / "good.tactspace.json", folder.path / "bad.ahap"});
    program.wait_for_opening();
    CHECK(app.work.document.set.vibrations.size() == 4);
    CHECK(has(app.ui.status.text, "1 file read, 1 not"));
    for (int k = 0; k < 1000; ++k) program.frame();  // longer than other lines stay
    program.click("link:status more");
    REQUIRE(app.ui.question);
    CHECK(has(app.ui.question->text, "bad.ahap"));
    program.press_key(key::kEnter);
    program.click("status:dismiss");
    CHECK(app.ui.status.text.empty());
    run(program, "Files not read...");
    REQUIRE(app.ui.question);
    CHECK(has(app.ui.question->text, "bad.ahap"));
}

TEST_CASE("opening: a file that cannot be read changes nothing") {
    Program program(short_patterns(2));
    App& app = program.app;
    begin_jobs(app);
    const TemporaryFolder folder;
    folder.write("bad.ahap", "{");
    const PatternSet before = app.work.document.set;
    open_paths(app.ui, app.work, app.opening, {folder.path / "bad.ahap"});
    program.wait_for_opening();
    CHECK(app.ui.status.is_error);
    CHECK(has(app.ui.status.text, "bad.ahap"));
    CHECK(app.work.document.set == before);
}

}  // namespace opening_test
