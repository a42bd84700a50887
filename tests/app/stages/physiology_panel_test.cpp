// The physiology pane through the program's real frames: one playhead, one time axis, and the
// numbers of the command line.
#include <doctest/doctest.h>

#include <sstream>

#include "model/io/set/set_file.h"
#include "tests/support/physiology_program.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace physiology_panel_test {

using namespace tact;

namespace {

// Output    of `tactspace stages` for a pattern of the set.
struct Written {
    TemporaryFolder folder;

    Written(const PatternSet& set, const std::string& pattern) {
        const auto file = folder.path / "set.tactspace.json";
        REQUIRE(write_set_file(file, set));
        const Ran ran = run_program({"stages", file.string(), "--pattern", pattern, "--out",
                                     (folder.path / "stages").string()});
        REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    }

    std::vector<std::vector<std::string>> rows(const std::string& name) const {
        std::istringstream lines(bytes_of(folder.path / "stages" / name));
        std::vector<std::vector<std::string>> all;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream cells(line);
            all.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
        }
        REQUIRE(all.size() > 1);
        all.erase(all.begin());
        return all;
    }
};

}  // namespace

TEST_CASE("physiology: numbers under the cursor are those that the command line writes") {
    const PatternSet set = rich_patterns();
    PhysiologyProgram program(set);
    const Written written(set, "p1");
    struct Signal {
        const char* row;
        const char* file;
        std::size_t column;
    };
    for (const Signal& signal :
         {Signal{"vibration", "input.csv", 1}, Signal{"filtered FA1", "filtered.csv", 1},
          Signal{"filtered FA2", "filtered.csv", 2}, Signal{"central FA2", "central.csv", 3},
          Signal{"brain", "brain_waveform.csv", 1}, Signal{"envelope", "envelope.csv", 1}}) {
        const auto rows = written.rows(signal.file);
        for (const float share : {0.21F, 0.55F, 0.83F}) {
            program.hover(program.in_row(signal.row, share));
            const auto cells = program.under_the_mouse(signal.row);
            const std::size_t sample = std::stoul(cells[0]);
            INFO(signal.row << " sample " << sample);
            REQUIRE(sample < rows.size());
            CHECK(std::stod(cells[1]) == std::stod(rows[sample][signal.column]));
        }
    }
}

TEST_CASE(
    "physiology: a component, a receptor and a relay neuron say what the command line writes" *
    doctest::test_suite("long")) {
    const PatternSet set = rich_patterns();
    PhysiologyProgram program(set);
    const Written written(set, "p1");

    // At some place of the spectrum there is a component under the mouse.
    std::vector<std::string> found;
    for (float share = 0.05F; share < 0.95F && found.empty(); share += 0.01F) {
        program.hover(program.in_row("spectrum", share));
        if (program.shows("under the mouse:spectrum")) found = program.under_the_mouse("spectrum");
    }
    REQUIRE(found.size() == 2);
    bool listed = false;
    for (const auto& row : written.rows("spectrum.csv")) {
        listed |=
            std::stod(row[0]) == std::stod(found[0]) && std::stod(row[2]) == std::stod(found[1]);
    }
    CHECK(listed);

    program.click("stage:receptors");
    for (const char* afferent : {"FA1", "FA2"}) {
        const Place grid = program.at(std::string("grid ") + afferent);
        const auto activation = written.rows("activation.csv");
        const std::size_t line = std::string(afferent) == "FA1" ? 0 : 1;
        std::istringstream shown(grid.value);
        double rate_hz = 0.0;
        double activated = 0.0;
        double radius_mm = 0.0;
        shown >> rate_hz >> activated >> radius_mm;
        CHECK(rate_hz == std::stod(activation[line][1]));
        CHECK(radius_mm == std::stod(activation[line][3]));
        CHECK(activated == std::stod(activation[line][5]));
    }
    // The receptor at the probe is in the middle of the map's square.
    const Place grid = program.at("grid FA2");
    std::vector<std::string> receptor;
    for (float y = grid.min.y; y < grid.max.y && receptor.empty(); y += 3.0F) {
        program.hover({grid.middle().x, y});
        if (program.shows("under the mouse:receptor")) {
            receptor = program.under_the_mouse("receptor");
        }
    }
    REQUIRE(receptor.size() == 5);
    bool same = false;
    for (const auto& row : written.rows("receptors.csv")) {
        if (row[0] != receptor[0] || row[1] != receptor[1]) continue;
        same = std::stod(row[4]) == std::stod(receptor[2]) &&
               std::stod(row[5]) == std::stod(receptor[3]) && row[7] == receptor[4];
    }
    CHECK(same);

    program.click("stage:networks");
    const Place network = program.at("network FA2");
    program.app.timeline.playhead.at_s = 0.0301;
    program.settle();
    std::vector<std::string> cell;
    for (float x = network.min.x; x < network.max.x; x += 4.0F) {
        for (float y = network.min.y; y < network.max.y; y += 6.0F) {
            program.hover({x, y});
            if (!program.shows("under the mouse:network")) continue;
            cell = program.under_the_mouse("network");
            if (std::stod(cell[5]) > 0.0) break;
        }
        if (!cell.empty() && std::stod(cell[5]) > 0.0) break;
    }
    REQUIRE(cell.size() == 6);
    CHECK(cell[1] == "6");
    double value = 0.0;
    for (const auto& row : written.rows("layers.csv")) {
        if (row[0] == cell[0] && row[1] == cell[1] && row[2] == cell[2] && row[3] == cell[3] &&
            row[4] == cell[4]) {
            value = std::stod(row[5]);
        }
    }
    CHECK(value == std::stod(cell[5]));
}

TEST_CASE("physiology: a stage opens large from the strip or by its name, Esc goes back") {
    PhysiologyProgram program;
    program.click("stage:spikes");
    CHECK(program.app.physiology.view.open == Stage::spikes);
    CHECK_FALSE(program.shows("plot:brain"));
    program.press_key(key::kEscape);
    CHECK_FALSE(program.app.physiology.view.open);
    program.click("label:brain");
    CHECK(program.app.physiology.view.open == Stage::brain);
    program.click("stage:all");
    CHECK(program.shows("plot:brain"));
}

TEST_CASE(
    "physiology: the head of the stages is one line in a wide pane, and two in a narrow one") {
    PhysiologyProgram program;
    const auto is_in_line = [&](const char* what, const char* with) {
        const float y = program.at(what).middle().y;
        return y > program.at(with).min.y && y < program.at(with).max.y;
    };
    program.app.layout.maximised = Pane::physiology;
    program.settle();
    for (const char* what : {"compare with", "start tour", "stages:fold"}) {
        CHECK(is_in_line(what, "stage:all"));
    }
    program.click("stage:receptors");
    CHECK(is_in_line("view:Tilted", "label:receptors"));

    program.app.layout.maximised.reset();
    program.app.layout.physiology = Fold::open;
    program.resize({1000.0F, 720.0F}, 1.0F);
    program.settle();
    REQUIRE(program.shows("stages:more"));
    CHECK(is_in_line("stages:more", "stage:envelope"));
    CHECK_FALSE(program.shows("compare with"));
    CHECK_FALSE(program.shows("hint:physiology"));
    program.click("stages:more");
    program.click("stages:fold");
    CHECK(program.app.layout.physiology == Fold::row);
}

TEST_CASE("physiology: stages keep their names at every size of text, before the i beside them") {
    PhysiologyProgram program;
    for (const float scale : {1.0F, 1.5F, 2.0F}) {
        CAPTURE(scale);
        program.resize({1600.0F, 1000.0F}, scale);
        for (const char* stage : {"vibration", "spikes", "central", "brain"}) {
            CAPTURE(stage);
            const Place& label = program.at(std::string("label:") + stage);
            CHECK(label.max.x - label.min.x > 25.0F * scale);  // three dots are 8 wide
        }
    }
}

TEST_CASE("physiology: the i of a stage explains it, and leads on to the next") {
    PhysiologyProgram program;
    program.click("explain:networks");
    CHECK(program.at("explanation").value == "networks");
    program.click("explain:next");
    CHECK(program.at("explanation").value == "central");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("explanation"));
}

TEST_CASE("physiology: every stage has all that its explanation promises") {
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        for (const char* part : {text.key, text.name, text.short_name, text.detail, text.in_body,
                                 text.in_model, text.equation, text.left_out, text.ours}) {
            REQUIRE(part != nullptr);
            CHECK(*part != '\0');
        }
        CHECK(stage_named(text.key) == stage);
    }
    CHECK_FALSE(stage_named("all"));
}

TEST_CASE("physiology: a receptor selected in its grid stands out in the raster, and back") {
    PhysiologyProgram program;
    program.click("stage:receptors");
    const Place grid = program.at("grid FA1");
    for (float y = grid.min.y; y < grid.max.y && !program.app.physiology.view.selected; y += 3.0F) {
        program.window.click({grid.middle().x, y});
        program.settle();
    }
    REQUIRE(program.app.physiology.view.selected);
    CHECK(program.app.physiology.view.selected->type == Receptor::meissner);
    program.click("stage:spikes");
    const Place raster = program.at("plot:raster");
    program.window.click({raster.middle().x, raster.min.y + 0.6F * (raster.max.y - raster.min.y)});
    program.settle();
    CHECK(program.app.physiology.view.selected);
}

TEST_CASE("physiology: a pinned pattern runs below, with the difference between them") {
    PhysiologyProgram program;
    program.click("compare with");
    program.click("pin:p2");
    program.wait_for_stages();
    const float above = program.at("plot:brain").max.y;
    const Place between = program.at("plot:brain difference");
    CHECK(between.min.y >= above - 1.0F);
    CHECK(program.at("plot:brain pinned").min.y >= between.max.y - 1.0F);
    const auto& difference = program.app.physiology.view.difference;
    REQUIRE(difference.stages[index_of(Stage::brain)]);
    CHECK(*difference.stages[index_of(Stage::brain)] > 0.0);
    const auto& a = program.app.physiology.stages->brain_waveform;
    const auto& b = program.app.physiology.pinned_stages->brain_waveform;
    const auto& apart = difference.signals[index_of(Stage::brain)][0];
    REQUIRE(apart.size() == a.size());
    for (std::size_t n = 0; n < a.size(); n += 37) CHECK(apart[n] == a[n] - b[n]);
    program.click("unpin");
    CHECK_FALSE(program.shows("plot:brain pinned"));
}

TEST_CASE("physiology: both of a pair have one scale, and rows of one height") {
    PatternSet set = rich_patterns();
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 0.2;
    PhysiologyProgram program(set);
    const auto largest_hz = [&] {
        program.app.physiology.view.open = Stage::receptors;
        program.settle();
        return std::stod(program.at("receptor key").value);
    };
    const double of_weak_hz = largest_hz();
    program.app.work.selection.pinned = "p2";
    program.settle();
    program.wait_for_stages();
    CHECK(largest_hz() > of_weak_hz);
    program.app.physiology.view.open = Stage::filtered;
    program.settle();
    const auto height = [&](const std::string& plot) {
        const Place place = program.at("plot:filtered " + plot);
        return place.max.y - place.min.y;
    };
    CHECK(height("FA1") == doctest::Approx(height("FA1 difference")).epsilon(0.2));
    CHECK(height("FA2") == doctest::Approx(height("FA2 pinned")).epsilon(0.05));
}

TEST_CASE("physiology: a twin of the pattern differs from it nowhere") {
    PatternSet set = rich_patterns();
    set.vibrations[1].source = set.vibrations[0].source;
    PhysiologyProgram program(set);
    program.app.work.selection.pinned = "p2";
    program.frame();
    program.wait_for_stages();
    for (const Stage stage : kStages) {
        const auto& difference = program.app.physiology.view.difference.stages[index_of(stage)];
        if (difference) CHECK(*difference == 0.0);
    }
}

TEST_CASE("physiology: silence, saturation, nothing at all and an edit under way are drawn") {
    PatternSet set = rich_patterns();
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 0.0;
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 50.0;
    PhysiologyProgram program(set);
    for (std::size_t k = 0; k < 3; ++k) {
        select_only(program.app.work, k);
        program.frame();
        program.wait_for_stages();
        for (const Stage stage : kStages) {
            program.click(std::string("stage:") + text_of(stage).key);
            program.app.physiology.view.tilted = k == 1;
            program.frame();
        }
        program.click("stage:all");
    }
    // The job has not answered this edit yet, so the shown stages are stale.
    std::get<Pattern>(program.app.work.document.edit().vibrations[2].source).amplitude_g = 0.3;
    program.frame();
    CHECK(program.shows("plot:brain"));
    Program empty((PatternSet()));
    CHECK_FALSE(empty.shows("plot:brain"));
}

}  // namespace physiology_panel_test
