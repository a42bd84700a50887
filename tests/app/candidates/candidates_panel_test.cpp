// The set as a table: sorting, filtering, many at once, who is picked.
#include "app/candidates/candidates.h"
#include "app/document/editing.h"
#include "app/subset/subset.h"
#include "model/set/vibration_search.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace candidates_panel_test {

using namespace tact;

namespace {

// 60, 110, 160, 210, 260 Hz; modulation 0, 10, 20, 0, 10 Hz.
struct Tabled : Program {
    Tabled() : Program(short_patterns(5)) {
        app.ui.motion = false;
        app.layout.bench = BenchTab::candidates;
        compute_map();
        settle();
    }

    std::vector<std::size_t> order() const {
        std::vector<std::size_t> listed;
        for (const CandidateRow& row : app.candidates.rows) listed.push_back(row.place);
        return listed;
    }

    void search_for(const std::string& text) {
        app.work.selection.search = text;
        settle();
    }

    void wait_for_pick(std::size_t count) {
        const auto until = end_of_patience();
        const Selection& selection = app.work.selection;
        while (selection.picked.size() != count || selection.is_pick_preview) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }
};

using Places = std::vector<std::size_t>;

}  // namespace

TEST_CASE("candidates: a click on a heading sorts, another turns the order round") {
    Tabled program;
    CHECK(program.order() == Places{0, 1, 2, 3, 4});
    program.click("candidates:by Hz");
    CHECK(program.order() == Places{0, 1, 2, 3, 4});
    program.click("candidates:by Hz");
    CHECK(program.order() == Places{4, 3, 2, 1, 0});
    program.click("candidates:by mod Hz");
    CHECK(program.order() == Places{0, 3, 1, 4, 2});  // equal ones as in the set
    program.click("candidates:by set");
    CHECK(program.order() == Places{0, 1, 2, 3, 4});
}

TEST_CASE("candidates: the nearest is the smallest PM of the row, whoever sorts") {
    Tabled program;
    const Dissimilarity& pm = program.app.shown_map.transition.shown->prediction.pm;
    program.click("candidates:by nearest");
    double last = std::numeric_limits<double>::infinity();
    for (const CandidateRow& row : program.app.candidates.rows) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 5; ++k) {
            if (k != row.place) least = std::min(least, pm(row.place, k));
        }
        CHECK(row.nearest_pm == least);
        CHECK(least <= last);
        last = least;
    }
}

TEST_CASE("candidates: what is typed finds numbers and rhythms, whole ones alone") {
    Tabled program;
    std::get<Pattern>(program.app.work.document.edit().vibrations[1].source).rhythm.text = "x--x";
    document_changed(program.app.work);
    program.search_for("110 Hz");
    CHECK(program.order() == Places{1});
    program.search_for("10Hz");
    CHECK(program.order() == Places{1, 4});  // the modulation, not 110 or 210
    program.search_for("X--x");
    CHECK(program.order() == Places{1});
    program.search_for("steady 10 hz");
    CHECK(program.order() == Places{4});
    program.search_for("p3");
    CHECK(program.order() == Places{2});
    program.search_for("nobody");
    CHECK(program.order().empty());
}

TEST_CASE("candidates: rows between two, as they are sorted, are locked in one step") {
    Tabled program;
    program.click("candidates:by mod Hz");  // 0, 3, 1, 4, 2
    program.click("candidate:p4");
    push(program.window.input, {program.window.now_s, KeyChange{key::kLeftShift, true, false, 0}});
    program.settle();
    program.click("candidate:p5");
    push(program.window.input, {program.window.now_s, KeyChange{key::kLeftShift, false, false, 0}});
    program.settle();
    CHECK(selected_indices(program.app.work) == Places{1, 3, 4});
    const PatternSet before = program.app.work.document.set;
    program.click("candidates:lock");
    const auto& all = program.app.work.document.set.vibrations;
    for (std::size_t k = 0; k < all.size(); ++k) CHECK(all[k].locked == (k == 1 || k >= 3));
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("candidates: arrows go through the rows as they are sorted") {
    Tabled program;
    program.click("candidates:by mod Hz");  // 0, 3, 1, 4, 2
    program.click("candidate:p1");
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 3);
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 1);
    program.press_key(key::kUp);
    CHECK(program.app.work.selection.current == 3);
    program.app.layout.bench = BenchTab::matrix;
    program.settle();
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 4);
}

TEST_CASE(
    "candidates: the menu of a row is for all that are selected, of others for the row alone") {
    Tabled program;
    program.click("candidate:p2");
    const auto open_menu = [&program](const std::string& row) {
        program.window.move(program.at(row).middle());
        program.window.button(true, 1);
        program.settle();
        program.window.button(false, 1);
        program.settle();
    };
    program.app.work.selection.others = {3};
    open_menu("candidate:p4");
    program.click("row menu:Exclude");
    const auto& all = program.app.work.document.set.vibrations;
    CHECK(all[1].dropped);
    CHECK(all[3].dropped);
    open_menu("candidate:p1");
    program.click("row menu:Lock");
    CHECK(all[0].locked);
    CHECK_FALSE(all[1].locked);
}

TEST_CASE("candidates: who is picked is marked in table and list, and can be all that is shown") {
    Tabled program;
    program.app.picking.count = 3;
    program.wait_for_pick(3);
    const std::set<std::string> picked = program.app.work.selection.picked;
    REQUIRE(picked.size() == 3);
    for (const std::string& name : names_of(program.app.work.document.set)) {
        CAPTURE(name);
        CHECK(program.shows("picked:" + name) == picked.contains(name));
        CHECK(program.at("candidate:" + name).value == (picked.contains(name) ? "picked" : ""));
    }
    program.click("candidates:only picked");
    CHECK(program.app.candidates.rows.size() == 3);
    CHECK(listed_indices(program.app.work).size() == 3);
    program.click("button:only picked");
    CHECK(program.app.candidates.rows.size() == 5);
}

TEST_CASE("candidates: a narrow table keeps name, numbers and who is picked") {
    const auto has = [](const std::vector<ColumnSpan>& places, CandidateColumn column) {
        return std::ranges::find(places, column, &ColumnSpan::column) != places.end();
    };
    for (const float width : {300.0F, 420.0F, 560.0F, 900.0F, 1600.0F}) {
        CAPTURE(width);
        const auto places = column_places(width, 1.0F);
        CHECK(has(places, CandidateColumn::name));
        CHECK(has(places, CandidateColumn::nearest));
        CHECK(has(places, CandidateColumn::picked));
        CHECK(places.back().end_px <= width + 0.5F);
        if (width > 499.0F) CHECK(places.back().end_px > width - 1.0F);
        CHECK(has(places, CandidateColumn::picture) == (width > 499.0F));
    }
}

TEST_CASE("candidates: the largest PM has room beside the other numbers") {
    constexpr float kLargestPx = 85.0F;
    for (const float width : {520.0F, 700.0F, 1600.0F}) {
        CAPTURE(width);
        const auto places = column_places(width, 1.0F, kLargestPx);
        const auto nearest =
            std::ranges::find(places, CandidateColumn::nearest, &ColumnSpan::column);
        REQUIRE(nearest != places.end());
        CHECK(nearest->end_px - nearest->begin_px >= 0.96F * kLargestPx);
        CHECK(places.back().end_px <= width + 0.5F);
    }
}

TEST_CASE("candidates: what is drawn shows its peak, its mean frequency and its ticks") {
    PatternSet set = short_patterns(3);
    auto& drawn = std::get<Pattern>(set.vibrations[1].source);
    drawn.amplitude_g = 2.0;
    drawn.modulation = {};
    drawn.duration_s = 1.0;
    drawn.amplitude_curve = {{0.0, 0.25}, {1.0, 0.25}};
    drawn.frequency_curve = {{0.0, 100.0}, {1.0, 300.0}};
    drawn.transients = {{0.2, 0.9, 150.0, 0.02}, {0.6, 0.4, 150.0, 0.02}};
    auto& ticks = std::get<Pattern>(set.vibrations[2].source);
    ticks.amplitude_g = 0.0;
    ticks.transients = {{0.02, 0.7, 80.0, 0.02}};
    Program program(set);
    program.app.layout.bench = BenchTab::candidates;
    program.settle();
    const auto& rows =
        candidate_rows(program.app.work, program.app.shown_map, program.app.candidates);
    REQUIRE(rows.size() == 3);
    CHECK_FALSE(rows[0].peak_g);
    CHECK(number_in(rows[0], CandidateColumn::carrier) == 60.0);
    CHECK(number_in(rows[1], CandidateColumn::amplitude) == doctest::Approx(0.9));
    // 0.5 g for 1 s at 200 Hz on the mean, and 0.026 g s at 150 Hz.
    CHECK(number_in(rows[1], CandidateColumn::carrier) ==
          doctest::Approx((0.5 * 200.0 + 0.026 * 150.0) / 0.526));
    CHECK(rows[1].ticks == 2);
    CHECK(number_in(rows[2], CandidateColumn::amplitude) == doctest::Approx(0.7));
    CHECK(number_in(rows[2], CandidateColumn::carrier) == doctest::Approx(80.0));
}

TEST_CASE("candidates: all that nobody feels are excluded by one press, but for locked ones") {
    PatternSet set = short_patterns(6);
    for (const std::size_t k : {1U, 2U, 4U}) {
        std::get<Pattern>(set.vibrations[k].source).amplitude_g = 0.0;
    }
    set.vibrations[4].locked = true;
    Program program(set);
    App& app = program.app;
    app.layout.bench = BenchTab::candidates;
    program.compute_map();
    program.settle();
    REQUIRE(unfelt_indices(app.work) == std::vector<std::size_t>{1, 2});
    program.click("candidates:exclude unfelt");
    const auto& all = app.work.document.set.vibrations;
    for (std::size_t k = 0; k < all.size(); ++k) CHECK(all[k].dropped == (k == 1 || k == 2));
    CHECK(app.ui.status.text.starts_with("Excluded 2 patterns that no receptor answers to."));
    CHECK_FALSE(program.shows("candidates:exclude unfelt"));
    undo(app.ui, app.work);
    CHECK_FALSE(all[1].dropped);
    CHECK_FALSE(all[2].dropped);
}

}  // namespace candidates_panel_test
