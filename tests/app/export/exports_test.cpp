// Exports from the window: the same files as from the command line, whole, and never in the way.
#include "app/export/export.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "app/document/editing.h"
#include "app/subset/subset.h"
#include "app/window/window.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace exports_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// A program whose document lies in a folder of its own, its stages there.
struct Exporting {
    TemporaryFolder folder;
    fs::path set_file = folder.path / "test.tactspace.json";
    Program program{short_patterns(3)};

    Exporting() {
        program.app.ui.motion = false;
        ExportState& exports = program.app.exports;
        exports.picture_size.width = exports.frame_size.width = 300;
        exports.picture_size.height = exports.frame_size.height = 400;
        App& app = program.app;
        app.work.document.open({app.work.document.set, set_file, app.work.document.saved});
        app.physiology.stages = snapshot_of(app)->app.physiology.stages;
        program.settle();
    }

    // As the window's loop does it.
    void frame() {
        program.frame();
        continue_exports(program.app);
    }

    void run(const std::string& command) {
        for (const Command& known : commands()) {
            if (known.name != command) continue;
            REQUIRE(known.enabled(program.app));
            known.run(program.app);
        }
        program.settle();
    }

    // Over the name that is offered.
    void answer(const fs::path& path) {
        REQUIRE(program.app.ui.chooser.is_open);
        program.window.type(path.string());
        program.settle();
        program.press_key(key::kEnter);
    }

    const std::string& status() const { return program.app.ui.status.text; }
};

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

bool is_whole_png(const std::string& bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1a\n") &&
           contains(std::string_view(bytes).substr(bytes.size() - 12), "IEND");
}

}  // namespace

TEST_CASE("exports: every command is in the File menu and the palette") {
    std::set<std::string> names;
    for (const Command& command : commands()) {
        if (std::string_view(command.menu) == "File") names.insert(command.name);
    }
    for (const char* name : {"Export view...", "Export stage as CSV...", "Export animation..."}) {
        CHECK(names.contains(name));
    }
}

TEST_CASE("exports: a view goes to the file chosen, PNG or SVG by its ending" *
          doctest::test_suite("long")) {
    Exporting exporting;
    Program& program = exporting.program;
    for (const PictureView view : kPictureViews) {
        for (const std::string ending : {".png", ".svg"}) {
            exporting.run("Export view...");
            program.app.exports.picture_size.width = 300;
            program.app.exports.picture_size.height = 400;
            program.app.exports.view = view;
            program.click("button:choose");
            CHECK(program.app.ui.chooser.name == std::string("test ") + name_of(view) + ".png");
            const fs::path file = exporting.folder.path / (name_of(view) + ending);
            exporting.answer(file);
            CHECK(is_exporting(program.app));
            exporting.frame();
            CHECK_FALSE(is_exporting(program.app));
            CHECK(exporting.status() == "Exported " + file.string());
            const std::string bytes = bytes_of(file);
            const bool whole = ending == ".png" ? is_whole_png(bytes) : contains(bytes, "</svg>");
            CHECK(whole);
        }
    }
}

namespace {

// What is noted, but for what is under the mouse.
std::map<std::string, std::string> noted(const std::string& lines) {
    std::map<std::string, std::string> all;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const std::string name = line.substr(0, line.find('\t'));
        const std::string value = line.substr(line.rfind('\t') + 1);
        if (name != "pointer") all[name] = value;
    }
    return all;
}

// Both windows are drawn in one frame, as they share their fonts.
std::map<std::string, std::string> still_window(Program& program) {
    const auto still = snapshot_of(program.app);
    still->app.ui.theme = program.app.ui.theme;
    still->app.ui.rects = {};
    still->app.ui.rects.file = "/dev/null/no such file";
    for (int k = 0; k < 3; ++k) {
        still->app.ui.rects.lines.clear();
        program.window.frame([&] { draw_still_window(still->app); });
    }
    return noted(still->app.ui.rects.lines);
}

}  // namespace

TEST_CASE("exports: the picture of the window shows what the window shows, tab by tab" *
          doctest::test_suite("long")) {
    Program program(short_patterns(9));
    App& app = program.app;
    app.ui.motion = false;
    app.shown_map.show_people = true;
    app.picking.count = 4;
    app.play.choice = {.id = "audio/an actuator", .channel = 2};
    app.work.selection.pinned = "p2";
    program.compute_map();
    program.wait_for_stages();
    show_compare(program, CompareView::table);
    wait_for_comparison(program);
    show_why(program);
    show_subset(program, SubsetView::pick);
    wait_until(program, [&] { return app.picking.curve && !is_subset_busy(app.picking); });
    app.candidates.by = CandidateColumn::name;
    app.candidates.descending = true;
    app.pattern_panes.strip.height = 222.0F;
    for (const Arrangement arrangement : {Arrangement::design, Arrangement::select}) {
        app.layout.arrangement = arrangement;
        for (const BenchRow& row : kBenchTabs) {
            CAPTURE(row.key);
            show_bench(program, row.tab);
            if (row.tab == BenchTab::device)
                wait_until(program, [&] { return app.rendered.shown != nullptr; });
            program.hover({0.0F, 0.0F});
            std::map<std::string, std::string> live;
            for (const auto& [name, place] : program.places) {
                if (name != "pointer") live[name] = place.value;
            }
            const auto still = still_window(program);
            for (const auto& [name, value] : live) {
                CHECK_MESSAGE(still.contains(name), name);
                if (still.contains(name)) CHECK_MESSAGE(still.at(name) == value, name);
            }
            for (const auto& [name, value] : still) CHECK_MESSAGE(live.contains(name), name);
        }
    }
}

TEST_CASE("exports: a picture is of the program as it is, and leaves it so") {
    Exporting exporting;
    App& app = exporting.program.app;
    const auto draw = [&app] {
        const auto still = snapshot_of(app);
        PictureSize size{300, 400, 1.0F, app.ui.dark, PictureFormat::png};
        return std::get<Image>(view_picture(*still, PictureView::physiology, 0.02, size));
    };
    const Image first = draw();
    CHECK((draw() == first));
    app.physiology.view.open = Stage::brain;
    CHECK_FALSE((draw() == first));
    app.physiology.view.open.reset();
    app.work.selection.pinned = "p2";
    CHECK_FALSE((draw() == first));
    app.work.selection.pinned.clear();
    app.timeline.playhead = {0.07, 0.1, true, true};
    app.work.selection.hovered = 2;
    CHECK((draw() == first));
    CHECK(app.timeline.playhead.at_s == 0.07);
    CHECK(app.timeline.playhead.playing);
    CHECK(app.work.selection.hovered == 2);
}

TEST_CASE("exports: a picture that cannot be written says so and stops nothing") {
    Exporting exporting;
    exporting.program.app.exports.picture = "/proc/no folder/a.png";
    exporting.frame();
    CHECK(exporting.program.app.ui.status.is_error);
    CHECK(contains(exporting.status(), "Not exported: /proc/no folder/a.png: cannot be written"));
    CHECK_FALSE(is_exporting(exporting.program.app));
}

TEST_CASE("exports: stages from the window are the files of tactspace stages, byte by byte") {
    Exporting exporting;
    Program& program = exporting.program;
    save_as(program.app.ui, program.app.work, exporting.set_file);
    select_only(program.app.work, 1);
    exporting.run("Export stage as CSV...");
    CHECK(program.app.ui.chooser.name == "p2 stages");
    const fs::path from_window = exporting.folder.path / "p2 stages";
    exporting.answer("p2 stages");
    CHECK(exporting.status() == "Exported 11 files into " + from_window.string());
    const fs::path from_command = exporting.folder.path / "command";
    output_of(
        {"stages", exporting.set_file.string(), "--pattern", "p2", "--out", from_command.string()});
    REQUIRE(names_in(from_window) == names_in(from_command));
    for (const std::string& name : names_in(from_window)) {
        CHECK((bytes_of(from_window / name) == bytes_of(from_command / name)));
    }
}

TEST_CASE("exports: stages of what a device plays are of that, and their folder says so") {
    Exporting exporting;
    Program& program = exporting.program;
    save_as(program.app.ui, program.app.work, exporting.set_file);
    program.app.rendered.by = {ActuatorKind::dualshock_4, 1.0};
    program.app.rendered.on = true;
    exporting.run("Export stage as CSV...");
    const std::string name = "p1 stages, as a DualShock 4 plays them, uncalibrated";
    CHECK(program.app.ui.chooser.name == name);
    exporting.answer(name);
    CHECK(contains(exporting.status(), "as a DualShock 4 plays them, uncalibrated"));
    const fs::path from_command = exporting.folder.path / "command";
    output_of({"stages", exporting.set_file.string(), "--pattern", "p1", "--rendered-by",
               "dualshock-4", "--out", from_command.string()});
    CHECK((bytes_of(exporting.folder.path / name / "input.csv") ==
           bytes_of(from_command / "input.csv")));
}

TEST_CASE("exports: of an open stage only its own files, and none replaced unasked") {
    Exporting exporting;
    Program& program = exporting.program;
    program.app.physiology.view.open = Stage::filtered;
    exporting.run("Export stage as CSV...");
    const fs::path out = exporting.folder.path / "p1 stages";
    program.press_key(key::kEnter);  // as offered
    CHECK(names_in(out) == std::set<std::string>{"filtered.csv", "perceived.csv"});

    exporting.folder.write("p1 stages/perceived.csv", "mine");
    exporting.run("Export stage as CSV...");
    program.press_key(key::kEnter);  // there is such a folder now: its content is shown
    CHECK(program.app.ui.chooser.listing.folder == out);
    program.press_key(key::kEnter);
    REQUIRE(program.app.ui.chooser.is_open);
    CHECK(program.app.ui.chooser.replacing == out / "filtered.csv");
    program.press_key(key::kEscape);  // keep it
    CHECK(bytes_of(out / "perceived.csv") == "mine");
    program.press_key(key::kEnter);
    program.press_key(key::kEnter);  // replace it
    CHECK_FALSE(program.app.ui.chooser.is_open);
    CHECK(bytes_of(out / "perceived.csv").starts_with("time_s,FA1,"));
}

TEST_CASE("exports: an animation is drawn a frame at a time while the window goes on") {
    Exporting exporting;
    Program& program = exporting.program;
    exporting.run("Export animation...");
    CHECK(program.app.exports.to_s == doctest::Approx(0.1));
    program.app.exports.frames = 4;
    program.app.exports.frame_size.width = 300;
    program.app.exports.frame_size.height = 400;
    program.settle();
    program.click("export as:Pictures in a folder");
    program.click("button:choose");
    CHECK(program.app.ui.chooser.name == "p1 frames");
    exporting.answer("p1 frames");
    const fs::path out = exporting.folder.path / "p1 frames";
    for (int k = 0; k < 4; ++k) {
        CHECK(wants_another_frame(program.app));
        CHECK(file_count(out) == static_cast<std::size_t>(k));
        exporting.frame();
        CHECK(contains(program.at("export progress").value,
                       "frame " + std::to_string(k + 1) + " of 4"));
    }
    CHECK_FALSE(is_exporting(program.app));
    CHECK(contains(exporting.status(), "Exported 4 frames. A film: ffmpeg "));
    std::set<std::string> pictures;
    for (const std::string& name : names_in(out)) {
        CHECK(is_whole_png(bytes_of(out / name)));
        pictures.insert(bytes_of(out / name));
    }
    CHECK(names_in(out) == std::set<std::string>{"frame_0001.png", "frame_0002.png",
                                                 "frame_0003.png", "frame_0004.png"});
    CHECK(pictures.size() == 4);
}

TEST_CASE("exports: an animation is one file, as much slower as asked for, or none at all") {
    Exporting exporting;
    Program& program = exporting.program;
    exporting.run("Export animation...");
    program.click("export preset:720");
    CHECK(program.app.exports.frame_size.width == 1280);
    program.app.exports.frame_size.width = 200;
    program.app.exports.frame_size.height = 120;
    program.app.exports.frames = 5;  // of 0.1 s, at 25 a second
    program.settle();
    CHECK(program.at("export:slower").value == "2");
    program.click("export as:APNG");
    program.click("button:choose");
    CHECK(program.app.ui.chooser.name == "p1.apng");
    exporting.answer("p1.apng");
    const fs::path out = exporting.folder.path / "p1.apng";
    for (int k = 0; k < 5; ++k) {
        CHECK_FALSE(fs::exists(out));
        exporting.frame();
    }
    CHECK(contains(bytes_of(out), "acTL"));
    CHECK(contains(exporting.status(), "2.00 times slower than life"));
    export_animation(program.app, exporting.folder.path / "b.gif");
    exporting.frame();
    program.press_key(key::kEscape);
    CHECK_FALSE(is_exporting(program.app));
    CHECK(exporting.status() == "Export cancelled; no file was written.");
    CHECK_FALSE(fs::exists(exporting.folder.path / "b.gif"));
}

TEST_CASE("exports: an MP4 says how long it takes, and one that is cancelled leaves nothing") {
    Exporting exporting;
    Program& program = exporting.program;
    const fs::path bin = exporting.folder.path / "bin";
    fs::create_directory(bin);
    // Stands in for ffmpeg: keeps what it is given.
    std::ofstream(bin / "ffmpeg") << "#!/bin/sh\nfor last; do :; done\ncat >\"$last\"\n";
    fs::permissions(bin / "ffmpeg", fs::perms::owner_all);
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", (bin.string() + ":" + path).c_str(), 1);
    program.app.exports.to_s = 0.1;
    program.app.exports.frames = 20;
    const fs::path out = exporting.folder.path / "a.mp4";
    const fs::path part = exporting.folder.path / "a.mp4.part";
    export_animation(program.app, out);
    ::setenv("PATH", path.c_str(), 1);
    for (int k = 0; k < 3; ++k) {
        program.window.now_s += 2.0;
        exporting.frame();
    }
    program.settle();
    CHECK(contains(program.at("export progress").value, "frame 4 of 20, "));
    CHECK(contains(program.at("export progress").value, " s left"));
    program.click("button:cancel export");
    CHECK_FALSE(is_exporting(program.app));
    CHECK(exporting.status() == "Export cancelled; no file was written.");
    CHECK_FALSE(fs::exists(out));
    CHECK_FALSE(fs::exists(part));
}

TEST_CASE("exports: an MP4 of an odd size is drawn at the even one, said before it and after it") {
    for (const auto& [format, is_told] :
         {std::pair{FilmFormat::gif, false}, {FilmFormat::apng, false}, {FilmFormat::mp4, true}}) {
        CHECK(film_size_words(format, {1000, 1001}).empty() != is_told);
        CHECK(film_size_words(format, {1000, 1002}).empty());
        CHECK(film_size(format, {1001, 1001}).width == (is_told ? 1002 : 1001));
    }
    Exporting exporting;
    Program& program = exporting.program;
    const fs::path bin = exporting.folder.path / "bin";
    fs::create_directory(bin);
    std::ofstream(bin / "ffmpeg") << "#!/bin/sh\nfor last; do :; done\ncat >\"$last\"\n";
    fs::permissions(bin / "ffmpeg", fs::perms::owner_all);
    program.app.exports.to_s = 0.1;
    program.app.exports.frames = 2;
    program.app.exports.film = FilmFormat::mp4;
    program.app.exports.frame_size.width = 64;
    program.app.exports.frame_size.height = 65;
    program.app.ui.dialog = kExportAnimationDialog;
    program.settle();
    CHECK(program.at("export:even").value == "64 \u00d7 66 pixels, as sides of an MP4 are even");
    program.app.exports.film = FilmFormat::gif;
    program.settle();
    CHECK_FALSE(program.shows("export:even"));
    program.press_key(key::kEscape);
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", (bin.string() + ":" + path).c_str(), 1);
    const fs::path out = exporting.folder.path / "a.mp4";
    export_animation(program.app, out);
    ::setenv("PATH", path.c_str(), 1);
    while (is_exporting(program.app)) exporting.frame();
    CHECK(contains(exporting.status(), "64 \u00d7 66 pixels, as sides of an MP4 are even"));
    CHECK(fs::file_size(out) == 2 * 64 * 66 * 4);
}

TEST_CASE("exports: an animation is of the moment it began, whatever is edited meanwhile") {
    Exporting exporting;
    App& app = exporting.program.app;
    app.exports.to_s = 0.1;
    app.exports.frames = 2;
    export_animation(app, exporting.folder.path / "still");
    while (is_exporting(app)) exporting.frame();
    export_animation(app, exporting.folder.path / "edited");
    edit_patterns(app.work, [](Pattern& pattern) { pattern.carriers[0].frequency_hz = 300.0; });
    while (is_exporting(app)) exporting.frame();
    for (const std::string name : {"frame_0001.png", "frame_0002.png"}) {
        CHECK((bytes_of(exporting.folder.path / "still" / name) ==
               bytes_of(exporting.folder.path / "edited" / name)));
    }
}

TEST_CASE("exports: a cancelled animation leaves whole frames, by button and by Esc") {
    for (const bool by_button : {true, false}) {
        Exporting exporting;
        Program& program = exporting.program;
        program.app.exports.to_s = 0.1;
        program.app.exports.frames = 50;
        const fs::path out = exporting.folder.path / "out";
        export_animation(program.app, out);
        for (int k = 0; k < 3; ++k) exporting.frame();
        if (by_button) {
            program.click("button:cancel export");
        } else {
            program.press_key(key::kEscape);
        }
        CHECK_FALSE(is_exporting(program.app));
        exporting.frame();
        CHECK(exporting.status() == "Export cancelled: 3 of 50 frames are in " + out.string());
        CHECK(file_count(out) == 3);
        for (const std::string& name : names_in(out)) CHECK(is_whole_png(bytes_of(out / name)));
    }
}

TEST_CASE("exports: an animation does not run on into the frames of a longer one") {
    Exporting exporting;
    App& app = exporting.program.app;
    exporting.folder.write("out/frame_0003.png", "of another film");
    exporting.folder.write("out/frame_plan.png", "no frame");
    app.exports.to_s = 0.1;
    app.exports.frames = 2;
    export_animation(app, exporting.folder.path / "out");
    CHECK_FALSE(is_exporting(app));
    CHECK(contains(exporting.status(), "holds frame_0003.png of a longer sequence"));
    CHECK(file_count(exporting.folder.path / "out") == 2);
    app.exports.frames = 3;
    export_animation(app, exporting.folder.path / "out");
    CHECK(is_exporting(app));
}

TEST_CASE("frames: equal steps from the begin, each as long as the film needs") {
    const FrameSequence sequence{"a b", 0.2, 0.8, 6};
    for (int k = 0; k < 6; ++k) {
        // 0.2 + k/10, to rounding.
        CHECK(std::abs(time_of_frame_s(sequence, k) - (0.2 + 0.1 * k)) < 1e-15);
    }
    CHECK(path_of_frame(sequence, 0) == fs::path("a b/frame_0001.png"));
    CHECK(path_of_frame(sequence, 9998) == fs::path("a b/frame_9999.png"));
    CHECK(film_speed({"", 0.0, 1.0, 30}) == "as fast as life");
    CHECK(film_speed({"", 0.0, 1.0, 600}) == "20.0 times slower than life");
    CHECK(film_speed({"", 0.0, 2.0, 30}) == "2.00 times faster than life");
    CHECK(contains(film_command("a b", 1600, 1000), "-i 'a b/frame_%04d.png' -pix_fmt"));
    CHECK(contains(film_command("a", 1600, 1001), "-vf 'pad="));
}

}  // namespace exports_test
