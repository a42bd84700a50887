#include "app/map/parts.h"

#include <algorithm>
#include <chrono>
#include <stop_token>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "model/io/tables/checkpoint.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace map_refining_test {

using namespace tact;

namespace {

// A coarse OC of nothing but ones, so that exact values stand out.
Refinement begun(const PatternSet& set) {
    Refinement refinement =
        begin_refinement(pattern_codes(model_waveforms(set), set.model, {}), set.model, {});
    refinement.coarse = {refinement.oc, 10};
    std::ranges::fill(refinement.coarse.oc.condensed, 1.0);
    return refinement;
}

// What refine() told before it was stopped after a number of parts.
struct Parts {
    std::size_t count = 0;
    double first_share = 0.0;
    bool is_kept = false;
    bool is_done = false;
};

Parts refined(Refinement& refinement, const PatternSet& set, const std::filesystem::path& file,
              std::size_t most = 1'000'000) {
    Parts parts;
    std::stop_source stop;
    PredictOptions options;
    options.stop = stop.get_token();
    Refining how{set, nullptr, file, {}, 0.0, 0.0};
    how.partly = [&](const Refinement& now, bool is_kept) {
        if (parts.count == 0) parts.first_share = exact_share(now);
        parts.is_kept = is_kept;
        if (++parts.count == most) stop.request_stop();
    };
    parts.is_done = refine(refinement, options, how);
    return parts;
}

}  // namespace

TEST_CASE("refining: what was finished before a stop is taken up, and the file goes at the end") {
    const TemporaryFolder folder;
    const auto file = folder.path / "maps" / "set.map-tiles";
    const PatternSet set = short_patterns(40);
    Refinement first = begun(set);
    const Parts before = refined(first, set, file, 3);
    CHECK_FALSE(before.is_done);
    CHECK(before.is_kept);
    CHECK(std::filesystem::exists(file));
    const double share = exact_share(first);
    CHECK(share < 1.0);
    Refinement second = begun(set);
    const Parts after = refined(second, set, file);
    CHECK(after.is_done);
    CHECK(after.first_share > share);
    CHECK(prediction_of(second).pm == predict(model_waveforms(set), set.model)->pm);
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("refining: a file of another state of the set is begun again, a foreign one left alone") {
    const TemporaryFolder folder;
    const auto file = folder.path / "set.map-tiles";
    PatternSet set = short_patterns(20);
    Refinement first = begun(set);
    refined(first, set, file, 2);
    std::get<Pattern>(set.vibrations[3].source).amplitude_g = 2.0;
    Refinement edited = begun(set);
    CHECK(refined(edited, set, file).is_done);
    CHECK(prediction_of(edited).pm == predict(model_waveforms(set), set.model)->pm);
    CHECK_FALSE(std::filesystem::exists(file));
    folder.write("set.map-tiles", "a diary");
    Refinement again = begun(set);
    const Parts parts = refined(again, set, file);
    CHECK(parts.is_done);
    CHECK_FALSE(parts.is_kept);
    CHECK(bytes_of(file) == "a diary");
}

TEST_CASE("refining: what one looks at comes first, then what lies near it") {
    Program program(short_patterns(6));
    App& app = program.app;
    program.compute_map();
    app.work.selection.current = 2;
    app.work.selection.others = {5};
    app.work.selection.hovered_last = 4;
    const auto rows = rows_looked_at(app.work, app.shown_map);
    REQUIRE(rows.size() == 6);
    CHECK(rows[0] == 4);
    CHECK(rows[1] == 2);
    CHECK(rows[2] == 5);
    const Eigen::MatrixXd& at = app.shown_map.transition.to;
    const auto far = [&](std::size_t k) {
        return (at.row(static_cast<Eigen::Index>(k)) - at.row(2)).norm();
    };
    CHECK(far(rows[3]) <= far(rows[4]));
    CHECK(far(rows[4]) <= far(rows[5]));
}

TEST_CASE("refining: what the camera sees comes before what lies outside of the pane") {
    Program program(short_patterns(12));
    App& app = program.app;
    program.compute_map();
    program.settle();
    SpaceCamera& camera = app.shown_map.camera;
    const Rect& pane = app.shown_map.pane;
    REQUIRE_FALSE(pane.empty());
    const Eigen::MatrixXd& at = app.shown_map.transition.to;
    const auto is_seen = [&](std::size_t k) {
        return pane.contains(
            project(camera, fit(at), pane, point_of(at, static_cast<Eigen::Index>(k))).at);
    };
    CHECK(is_seen(11));  // at first all are
    frame_points(camera, fit(at), pane, {point_of(at, 7), point_of(at, 3)});
    app.work.selection.current = 0;
    app.work.selection.others.clear();
    app.work.selection.hovered_last.reset();
    const auto rows = rows_looked_at(app.work, app.shown_map);
    REQUIRE(rows.size() == 12);
    CHECK(rows[0] == 0);
    const auto first_outside =
        std::find_if(rows.begin() + 1, rows.end(), [&](std::size_t k) { return !is_seen(k); });
    CHECK(first_outside - rows.begin() > 2);
    CHECK(first_outside != rows.end());
    CHECK(std::none_of(first_outside, rows.end(), is_seen));
}

TEST_CASE("refining: words tell how much is exact, how much may change, and that it is kept") {
    LiveMap map;
    map.request.preview = true;
    map.prediction.envelope_decimation = 40;
    CHECK(preview_words(map, true, 600.0).starts_with("A preview: up to 10 % of the orders"));
    CHECK(preview_words(map, false, 600.0).empty());  // nothing of it is exact yet
    map.exact_share = 0.5;
    const std::string words = preview_words(map, false, 600.0);
    CHECK(words.find("50 % exact") != std::string::npos);
    CHECK(words.find("up to 8 %") != std::string::npos);  // a quarter of the pairs of pairs are
    CHECK(words.find("restart") == std::string::npos);
    map.is_kept = true;
    CHECK(preview_words(map, false, 600.0).find("restart") != std::string::npos);
    CHECK(preview_words(map, false, 1.0).empty());
    map.request.preview = false;
    CHECK(preview_words(map, false, 600.0).empty());
}

TEST_CASE("refining: a map that was under way when the program ended continues by itself" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const PatternSet set = short_patterns(kMostLivePatterns + 1);
    const auto path = folder.path / "many.tactspace.json";
    const auto open_again = [&](Program& program) {
        App& app = program.app;
        begin_jobs(app);
        app.ui.waiting.push_back([&app, &set, &path] {
            show_document(app.ui, app.work, {set, path, set}, "Opened many.");
        });
        program.frame();
    };
    const auto wait_for = [](Program& program, const auto& condition) {
        const auto until = end_of_patience();
        while (!condition()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            program.frame();
        }
    };
    double share = 0.0;
    {
        Program program(short_patterns(2));
        App& app = program.app;
        open_again(program);
        wait_for(program, [&] { return program.shows("link:compute exact"); });
        program.click("link:compute exact");
        const auto& shown = app.shown_map.transition.shown;
        wait_for(program, [&] { return shown->is_kept && shown->exact_share > 0.0; });
        CHECK(map_state(app.work, app.shown_map) == MapState::preview);
        CHECK(program.at("map:preview").value.find("restart") != std::string::npos);
        share = shown->exact_share;
    }
    Program program(short_patterns(2));
    App& app = program.app;
    open_again(program);
    CHECK_FALSE(exact_waits(app.work, app.shown_map));
    const auto& shown = app.shown_map.transition.shown;
    wait_for(program, [&] { return shown && shown->exact_share > 0.0; });
    CHECK(shown->exact_share >= share);
}

}  // namespace map_refining_test
