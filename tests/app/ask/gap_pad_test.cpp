// Filling the gap, growing, and the pad, in the window.
#include <algorithm>
#include <string_view>

#include "app/ask/ask.h"
#include "app/map/map.h"
#include "app/window/window.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"

namespace gap_pad_test {

using namespace tact;

namespace {

struct Asked : Program {
    explicit Asked(const PatternSet& set) : Program(set) {
        app.ui.motion = false;
        begin_jobs(app);
    }

    void until_found() {
        const auto until = end_of_patience();
        while (is_filling(app.proposals)) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }
};

// Two patterns, and a design space of two by three levels.
PatternSet designed() {
    PatternSet set = short_patterns(2);
    DesignSpace space;
    space.amplitude_g = std::vector<double>{0.5, 1.0};
    space.carriers[0].frequency_hz = std::vector<double>{60.0, 110.0, 240.0};
    space.duration_s = fixed(0.1);
    set.generator = space;
    std::get<Pattern>(set.vibrations[1].source).modulation.frequency_hz = 0.0;
    return set;
}

}  // namespace

TEST_CASE("fill the gap: one pattern of the design space comes, proven, undone in one step") {
    Asked program(designed());
    const PatternSet before = program.app.work.document.set;
    fill_the_gap(program.app.ui, program.app.work, program.app.shown_map, program.app.proposals);
    program.settle();
    program.until_found();
    const auto& after = program.app.work.document.set.vibrations;
    REQUIRE(after.size() == before.vibrations.size() + 1);
    CHECK(after.back().name == "gap");
    CHECK(program.app.work.selection.current == after.size() - 1);
    INFO(program.at("status").value);
    CHECK(program.at("status").value.find(
              "the farthest of the 4 left in the design space, proven") != std::string::npos);
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("grow: as many come as are missing, in one step; where none is, it says so") {
    Asked program(designed());
    const PatternSet before = program.app.work.document.set;
    const auto grow = [&program](std::size_t count) {
        grow_to(program.app.ui, program.app.work, program.app.shown_map, program.app.proposals,
                count);
        program.settle();
        program.until_found();
    };
    grow(2);
    CHECK(program.at("status").value.find("none is missing") != std::string::npos);
    CHECK_FALSE(program.app.ui.status.is_error);  // advice is no error
    CHECK(program.app.work.document.set == before);
    grow(5);
    CHECK(program.app.work.document.set.vibrations.size() == 5);
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("grow: the Subset tab offers it where fewer are there than are to be picked") {
    Asked program(designed());
    program.compute_map();
    program.app.layout.bench = BenchTab::subset;
    program.app.picking.count = 2;
    program.settle();
    CHECK_FALSE(program.shows("link:grow"));
    program.app.picking.count = 4;
    program.settle();
    program.click("link:grow");
    program.until_found();
    CHECK(program.app.work.document.set.vibrations.size() == 4);
}

TEST_CASE("fill the gap: Esc and an edit end the search, and nothing is added") {
    Asked program(short_patterns(3));
    fill_the_gap(program.app.ui, program.app.work, program.app.shown_map, program.app.proposals);
    program.press_key(key::kEscape);
    CHECK_FALSE(is_filling(program.app.proposals));
    CHECK(program.app.work.document.set.vibrations.size() == 3);
    fill_the_gap(program.app.ui, program.app.work, program.app.shown_map, program.app.proposals);
    std::get<Pattern>(program.app.work.document.edit().vibrations[0].source).amplitude_g = 0.7;
    document_changed(program.app.work);
    program.settle();
    CHECK_FALSE(is_filling(program.app.proposals));
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

TEST_CASE("pad: a drag moves the mix, Enter keeps it in one step, Esc keeps nothing") {
    Asked program(short_patterns(4));
    const PatternSet before = program.app.work.document.set;
    select_all(program.app.work);
    open_pad(program.app.ui, program.app.work, program.app.pad);
    program.settle();
    REQUIRE(program.app.pad.corners.size() == 4);
    const Place square = program.at("pad");
    program.drag(square.middle(), square.min + ImVec2{1.0F, 1.0F}, 4);
    CHECK(program.app.pad.right < 0.02);
    CHECK(program.app.pad.down < 0.02);
    program.press_key(key::kEscape);
    CHECK(program.app.work.document.set == before);
    open_pad(program.app.ui, program.app.work, program.app.pad);
    program.settle();
    const Pattern mix = program.app.pad.mix;
    program.press_key(key::kEnter);
    const auto& after = program.app.work.document.set.vibrations;
    REQUIRE(after.size() == 5);
    CHECK(program.pattern(program.app.work.selection.current) == mix);
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("pad: it takes two patterns") {
    Asked program(short_patterns(4));
    open_pad(program.app.ui, program.app.work, program.app.pad);
    CHECK(program.app.ui.dialog == kNoDialog);
    CHECK_FALSE(program.app.ui.status.is_error);  // advice is no error
    const auto mix =
        std::ranges::find(commands(), std::string_view("Mix on a pad..."), &Command::name);
    REQUIRE(mix != commands().end());
    CHECK(std::string(what_lacks(program.app, *mix)) == "select two to four patterns first");
    toggle_selected(program.app.work, 2);
    CHECK(what_lacks(program.app, *mix) == nullptr);
}

TEST_CASE("move tool: a drag of a point searches its pattern; without it the point stays") {
    Asked program(short_patterns(5));
    program.compute_map();
    program.settle();
    const auto drag_first = [&program] {
        const ImVec2 at = program.at("point:p1").middle();
        program.drag(at, at + ImVec2{30.0F, -20.0F}, 4);
    };
    drag_first();
    CHECK_FALSE(program.app.proposals.put.job.asked());
    program.click("tool:move");
    drag_first();
    CHECK(program.app.proposals.put.job.asked());
    program.press_key(key::kEscape);
    CHECK_FALSE(program.app.proposals.put.job.asked());
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("move tool: where it was to be and the other points stay until the next edit") {
    Asked program(short_patterns(5));
    program.compute_map();
    program.click("tool:move");
    const ShownMap& map = program.app.shown_map;
    const Eigen::MatrixXd before = map.transition.to;
    const ImVec2 at = program.at("point:p1").middle();
    program.drag(at, at + ImVec2{30.0F, -20.0F}, 4);
    REQUIRE(program.app.proposals.put.job.asked());
    const Eigen::RowVectorXd wanted = *program.app.proposals.put.wanted;
    wait_until(program, [&] { return !program.app.proposals.put.job.asked(); });
    REQUIRE(program.app.proposals.put.aim);
    CHECK(*program.app.proposals.put.aim == wanted);
    MapMaybes shown;
    show_put(shown, wanted.size(), program.app.proposals);
    CHECK(shown.wanted.has_value());
    const auto is_exact = [&] { return map_state(program.app.work, map) == MapState::exact; };
    wait_until(program, is_exact);
    program.settle();
    const auto row = static_cast<Eigen::Index>(program.app.work.selection.current);
    REQUIRE(map.transition.to.rows() == before.rows());
    for (Eigen::Index k = 0; k < before.rows(); ++k) {
        CAPTURE(k);
        CHECK((map.transition.to.row(k) == before.row(k)) == (k != row));
    }
    CHECK(program.shows("map:held"));
    undo(program.app.ui, program.app.work);
    program.settle();
    CHECK_FALSE(program.app.proposals.put.aim);
    CHECK_FALSE(program.shows("map:held"));
}

TEST_CASE("find similar: the closest by PM are selected, and named with how far they are") {
    Asked program(short_patterns(8));
    program.compute_map();
    select_similar(program.app.ui, program.app.work, program.app.shown_map, 2);
    const Dissimilarity& pm = program.app.shown_map.transition.shown->prediction.pm;
    const std::vector<std::size_t> selected = selected_indices(program.app.work);
    CHECK(selected.size() == 1 + kSimilarOnes);
    double farthest = 0.0;
    for (const std::size_t k : selected) {
        if (k != 2) farthest = std::max(farthest, pm(2, k));
    }
    for (std::size_t k = 0; k < 8; ++k) {
        const bool is_in = std::ranges::find(selected, k) != selected.end();
        if (!is_in) CHECK(pm(2, k) >= farthest);
    }
    CHECK(program.app.ui.status.text.starts_with("Closest to p3: "));
}

}  // namespace gap_pad_test
