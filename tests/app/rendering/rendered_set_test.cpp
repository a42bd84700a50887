#include "app/rendering/rendering.h"

#include <optional>

#include "app/compare/compare.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace rendered_set_test {

using namespace tact;

namespace {

std::shared_ptr<const Waveform> played(const RenderedSet& made, std::size_t k) {
    return std::get<Measurement>(made.played.vibrations[k].source).waveform;
}

std::optional<LiveMap> map_of(LiveMapWork& work, const PatternSet& set,
                              const std::optional<RenderedBy>& by) {
    std::atomic<float> progress = 0.0F;
    LiveMapRequest request{1, 1, std::make_shared<const PatternSet>(set), 3, false};
    request.rendered_by = by;
    return work(request, {}, progress);
}

}  // namespace

TEST_CASE("rendered set: every pattern becomes what the device plays, and nothing else changes") {
    const PatternSet set = short_patterns(5);
    const RenderedBy by{ActuatorKind::switch_pro, 1.0};
    const RenderedSet made = *rendered_set(set, by);
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(*played(made, k) == rendering(by, waveform_of(set.vibrations[k])).waveform);
        CHECK(made.played.vibrations[k].name == set.vibrations[k].name);
    }
    CHECK(made.played.model == set.model);
    CHECK(made.intended == set);
    const RenderedSet again = *rendered_set(set, by, nullptr, {1, {}});
    CHECK(again.played == made.played);  // with one thread as with all
}

TEST_CASE("rendered set: after an edit only the edited pattern is rendered again") {
    PatternSet set = short_patterns(4);
    const RenderedBy by{ActuatorKind::joy_con, 1.0};
    const RenderedSet before = *rendered_set(set, by);
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 0.3;
    std::swap(set.vibrations[0], set.vibrations[1]);
    const RenderedSet after = *rendered_set(set, by, &before);
    CHECK(played(after, 0) == played(before, 1));  // the very same
    CHECK(played(after, 1) == played(before, 0));
    CHECK(played(after, 2) != played(before, 2));
    CHECK(played(after, 3) == played(before, 3));
    const RenderedSet other = *rendered_set(set, {ActuatorKind::joy_con, 2.0}, &after);
    CHECK(played(other, 3) != played(after, 3));
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(rendered_set(set, by, nullptr, {1, stop.get_token()}).has_value());
}

TEST_CASE("live map: of what a device plays it is the map of a set of those recordings") {
    const PatternSet set = short_patterns(4);
    const RenderedBy by{ActuatorKind::dualshock_4, 1.0};
    LiveMapWork work(1);
    const auto meant = map_of(work, set, std::nullopt);
    const auto rendered = map_of(work, set, by);
    LiveMapWork other(1);
    const auto expected = map_of(other, rendered_set(set, by)->played, std::nullopt);
    CHECK(rendered->prediction.pm == expected->prediction.pm);
    CHECK(rendered->prediction.nc != meant->prediction.nc);
    CHECK(*rendered->request.set == set);
    CHECK(*rendered->played == rendered_set(set, by)->played);
    CHECK(*meant->played == set);
    // And back: the answer from before.
    CHECK(map_of(work, set, std::nullopt)->prediction.codes == meant->prediction.codes);
}

TEST_CASE("stages: of what a device plays they begin with its waveform") {
    const PatternSet set = short_patterns(3);
    const RenderedBy by{ActuatorKind::simple_haptic, 1.0};
    std::atomic<float> progress = 0.0F;
    const auto live = compute_live_stages(stages_request(set, 1, by), {}, progress);
    const Waveform expected = rendering(by, waveform_of(set.vibrations[1])).waveform;
    CHECK(live->waveform == padded(expected, live->waveform.samples_g.size()));
    CHECK(stages_request(set, 1, by) != stages_request(set, 1));
}

TEST_CASE("rendered set: weaker than full, it says at which level") {
    RenderedBy by;
    CHECK(words_on(by) == "as a Joy-Con plays them, uncalibrated");
    by.level = 0.3;
    CHECK(words_on(by) == "as a Joy-Con plays them at a level of 30 %, uncalibrated");
    by = {ActuatorKind::phone_web, 1.0};
    CHECK(words_on(by) == "as a phone's browser plays them, uncalibrated");
    CHECK(strength_words(by).find("starts and stops, are guessed") != std::string::npos);
}

TEST_CASE("device tab: at the level of the bar it reports what is played, and follows the bar") {
    Program program(short_patterns(2));
    App& app = program.app;
    begin_jobs(app);
    document_changed(app.work);
    program.wait_for_exact_map();
    program.click("tab:Device");
    const auto wait_for = [&program](const char* words) {
        const auto until = end_of_patience();
        while (!program.shows("rendering:origin") ||
               !contains(program.at("rendering:origin").value, words)) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            program.frame();
        }
    };
    wait_for("at a level of 100 %, not the playback level");
    const double full = peak_g(app.rendered.shown->rendering.waveform);
    program.click("rendering:at bar level");
    REQUIRE(app.play.level < 1.0);
    wait_for("the playback level.");
    CHECK(app.rendered.by.level == app.play.level);
    app.play.level = 0.5;
    wait_for("at a level of 50 %, the playback level");
    CHECK(peak_g(app.rendered.shown->rendering.waveform) < full);
    program.click("rendering:at bar level");
    wait_for("at a level of 100 %");
    CHECK(app.rendered.by.level == 1.0);
}

TEST_CASE("device tab: the report stands there, and the switch makes the map that of the device") {
    Program program(short_patterns(4));
    App& app = program.app;
    begin_jobs(app);
    document_changed(app.work);
    program.wait_for_exact_map();
    const Dissimilarity meant = app.shown_map.transition.shown->prediction.nc;
    program.click("tab:Device");
    const auto until = end_of_patience();
    while (!program.shows("rendering:summary")) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        program.frame();
    }
    CHECK(program.at("rendering:summary").value.find("of its energy is lost") != std::string::npos);
    CHECK(contains(program.at("rendering:origin").value, "not measured, at a level of 100 %"));
    CHECK(program.shows("plot:intended"));
    CHECK(program.shows("plot:rendered"));
    CHECK(program.at("device caption:rendered").value.starts_with("played, peak "));
    CHECK(program.at("device caption:rendered").value.ends_with(" g"));
    CHECK(program.shows("band:41\u201375 Hz"));

    const PatternSet before = app.work.document.set;
    std::optional<MapState> at_first;  // of the frame that switched: a quick job is soon done
    program.after_frame = [&] {
        if (app.rendered.on && !at_first) at_first = map_state(app.work, app.shown_map);
    };
    program.click("rendered");
    CHECK(app.rendered.on);
    CHECK(at_first == MapState::stale);  // until it is computed the old map looks old
    program.after_frame = nullptr;
    program.wait_for_exact_map();
    CHECK(app.shown_map.transition.shown->prediction.nc != meant);
    CHECK(app.shown_map.transition.shown->request.rendered_by == std::optional(app.rendered.by));
    CHECK(rendered_words(app.rendered) == "as a Joy-Con plays them, uncalibrated");
    CHECK(app.work.document.set == before);
    CHECK_FALSE(app.work.unsaved);

    program.click("rendered");
    program.wait_for_exact_map();
    CHECK(app.shown_map.transition.shown->prediction.nc == meant);
}

}  // namespace rendered_set_test
