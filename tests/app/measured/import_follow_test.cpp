#include "app/measured/measured.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/opening/opening.h"
#include "app/study/study.h"
#include "app/window/window.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace import_follow_test {

using namespace tact;

namespace {

// Recordings of the first two patterns of the set, begun 10 ms early.
std::vector<std::filesystem::path> recorded(const Program& program, const TemporaryFolder& folder) {
    std::vector<std::filesystem::path> files;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vibration& vibration = program.app.work.document.set.vibrations[k];
        std::string text = "t,x (g)\n";
        const Waveform waveform = waveform_of(vibration);
        for (std::size_t n = 0; n < waveform.samples_g.size() + 100; ++n) {
            const double g = n < 100 ? 0.0 : waveform.samples_g[n - 100];
            text += shortest_digits(static_cast<double>(n) / kModelRateHz) + "," +
                    shortest_digits(g) + "\n";
        }
        files.push_back(folder.write(vibration.name + ".csv", text));
    }
    return files;
}

void wait_for_it(Program& program, const std::function<bool()>& done) {
    for (int k = 0; k < 2000 && !done(); ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        follow_import(program.app.ui, program.app.work, program.app.importing);
    }
    REQUIRE(done());
}

std::size_t count(const Program& program) {
    return program.app.work.document.set.vibrations.size();
}

}  // namespace

TEST_CASE("import: recordings find their patterns, and come in as one step that undo takes back") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    import_recordings(app.ui, app.work, app.importing, recorded(program, folder));
    CHECK(app.ui.dialog == kImportDialog);
    CHECK(app.importing.patterns[1] == app.work.document.set.vibrations[1].name);
    wait_for_it(program, [&] { return app.importing.answer != nullptr; });
    REQUIRE(app.importing.answer->files[0].twin);
    CHECK(app.importing.answer->files[0].twin->alignment.lag == 100);
    CHECK(count(program) == 4);  // so far only a look
    take_recordings(app.ui, app.work, app.importing);
    wait_for_it(program, [&] { return !is_taking(app.importing); });
    CHECK(count(program) == 6);
    CHECK(measures_another(app.work.document.set.vibrations[1]));
    undo(app.ui, app.work);
    CHECK(count(program) == 4);
    redo(app.ui, app.work);
    CHECK(count(program) == 6);
}

TEST_CASE(
    "import: a file that says volts itself is refused with a sentence, beside what it lacks") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    std::string text = "t,x (V)\n";
    for (int n = 0; n < 1000; ++n) {
        text += shortest_digits(1e-4 * n) + "," + (n % 2 == 0 ? "1" : "-1") + "\n";
    }
    import_recordings(app.ui, app.work, app.importing, {folder.write("p1.csv", text)});
    wait_for_it(program, [&] { return app.importing.answer != nullptr; });
    CHECK(contains(app.importing.answer->files[0].fault, "sensitivity in V/g"));
    program.settle();
    REQUIRE(program.shows("import:sensitivity"));
    app.importing.fields.options.sensitivity_v_per_g = 0.1;
    look_at_recordings(app.ui, app.work, app.importing);
    wait_for_it(program, [&] { return app.importing.answer->files[0].fault.empty(); });
    CHECK(app.importing.answer->files[0].twin);
}

TEST_CASE("import: of work that fails the sentence is told, and the next one begins") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    import_recordings(app.ui, app.work, app.importing, recorded(program, folder));
    take_recordings(app.ui, app.work, app.importing);
    take_recordings(app.ui, app.work, app.importing);
    app.importing.import_takes.job = Query<ImportRequest, ImportAnswer>();
    app.importing.import_takes.job.ask(app.importing.import_takes.waiting.front(),
                                       [](const ImportRequest&, std::stop_token,
                                          std::atomic<float>&) -> std::optional<ImportAnswer> {
                                           throw std::runtime_error("the disk is gone");
                                       });
    wait_for_it(program, [&] { return !is_taking(app.importing); });
    CHECK(contains(app.ui.status.text, "Not imported: the work failed: the disk is gone"));
    CHECK(count(program) == 4);
}

TEST_CASE("import: saved, the waveforms lie beside the set and the set reads again") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    simulate_measurement_dialog(app.ui, app.work, app.importing);
    wait_for_it(program, [&] { return app.importing.simulated != nullptr; });
    CHECK(app.importing.simulated->twins.size() == 1);  // measures the current pattern, for a look
    take_simulation(app.ui, app.work, app.importing);
    wait_for_it(program, [&] { return !is_taking(app.importing); });
    REQUIRE(count(program) == 8);
    CHECK(file_count(folder.path / "state" / "measured") == 4);
    save_as(app.ui, app.work, folder.path / "saved.tactspace.json");
    CHECK_FALSE(app.ui.status.is_error);
    CHECK(file_count(folder.path / "measured") == 4);
    std::filesystem::remove_all(folder.path / "state");
    const auto again = read_set_file(folder.path / "saved.tactspace.json");
    REQUIRE(again);
    CHECK(again->set.vibrations == app.work.document.set.vibrations);
}

TEST_CASE("import: the map is of the side that is shown, and its pairs are found by name") {
    Program program(with_synthetic_twins(short_patterns(4), {}));
    App& app = program.app;
    begin_jobs(app);
    show_side(app.work, Side::measured);
    program.wait_for_exact_map();
    CHECK(names_of(*app.shown_map.transition.shown->request.set) ==
          names_of(one_side(app.work.document.set, Side::measured)));
    CHECK(shown_patterns_text(app.work) == "4 measured of 8");
    const auto rows = rows_in_map(app.work, app.shown_map, {1, 5, PartnerKind::chosen});
    REQUIRE(rows);
    CHECK(*rows == std::pair<std::size_t, std::size_t>{0, 2});
    CHECK_FALSE(rows_in_map(app.work, app.shown_map, {0, 1, PartnerKind::chosen}));
    show_side(app.work, Side::both);
    program.wait_for_exact_map();
    CHECK(app.shown_map.transition.to.rows() == 8);
}

TEST_CASE("import: tables of accelerations are told from tables of ratings") {
    const TemporaryFolder folder;
    CHECK(are_accelerations({folder.write("a.csv", "t,x\n0,1\n0.001,2\n")}));
    CHECK_FALSE(are_accelerations({folder.write("b.csv", "a,b,rating\np,q,3\n")}));
    CHECK_FALSE(are_accelerations({folder.write("c.txt", "1\n2\n")}));
    CHECK_FALSE(are_accelerations({}));
}

TEST_CASE("import: what was asked for comes, though the dialog is opened again before it does") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    const auto files = recorded(program, folder);
    import_recordings(app.ui, app.work, app.importing, {files[0]});
    take_recordings(app.ui, app.work, app.importing);
    import_recordings(app.ui, app.work, app.importing,
                      {files[1]});  // a look, which only supersedes looks
    take_recordings(app.ui, app.work, app.importing);
    look_at_recordings(app.ui, app.work, app.importing);
    simulate_measurement_dialog(app.ui, app.work, app.importing);
    app.importing.simulate_all = false;
    take_simulation(app.ui, app.work, app.importing);
    look_at_simulation(app.ui, app.work, app.importing);
    CHECK(is_taking(app.importing));
    wait_for_it(program, [&] { return !is_taking(app.importing); });
    const auto twins_of = [&app](const std::string& name) {
        return std::ranges::count_if(
            app.work.document.set.vibrations, [&](const Vibration& vibration) {
                const auto* twin = std::get_if<Measurement>(&vibration.source);
                return twin != nullptr && twin->measures == name;
            });
    };
    CHECK(twins_of("p2") == 1);
    CHECK(twins_of("p1") >= 1);
    CHECK(twins_of("p1") + twins_of("p2") == 3);
}

TEST_CASE("import: twins of one document do not go into another one with equal names") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    const auto files = recorded(program, folder);
    const auto other = folder.path / "other.tactspace.json";
    REQUIRE(write_set_file(other, short_patterns(4)));
    import_recordings(app.ui, app.work, app.importing, files);
    take_recordings(app.ui, app.work, app.importing);
    simulate_measurement_dialog(app.ui, app.work, app.importing);
    take_simulation(app.ui, app.work, app.importing);
    open_paths(app.ui, app.work, app.opening, {other});
    wait_for_it(program, [&] { return !is_taking(app.importing); });
    CHECK(count(program) == 4);
    CHECK(contains(app.ui.status.text, "the set it was for is not open any more"));
    CHECK(app.ui.status.is_error);
}

TEST_CASE("import: nothing is dropped onto the window while something is being asked") {
    const TemporaryFolder folder;
    Program program(short_patterns(4));
    App& app = program.app;
    const auto other = folder.path / "other.tactspace.json";
    REQUIRE(write_set_file(other, short_patterns(2)));
    const auto stays = [&] {
        program.settle();
        drop_paths(app, {other});
        return count(program) == 4 && app.ui.status.is_error;
    };
    app.ui.dialog = kGenerateDialog;
    CHECK(stays());
    program.press_key(key::kEscape);
    app.ui.status = {};
    tell(app.ui, "A question", "Is it?");
    CHECK(stays());
    program.press_key(key::kEnter);
    app.ui.status = {};
    begin_participant(app.ui, app.work, app.timeline, app.play, app.studying);
    REQUIRE(is_study_running(app.studying));
    CHECK(stays());
    stop_study(app.studying);
    app.studying.run.reset();
    program.settle();
    drop_paths(app, {other});
    CHECK(count(program) == 2);
}

}  // namespace import_follow_test
