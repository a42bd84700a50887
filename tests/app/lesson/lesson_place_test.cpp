// Placing a pattern in the map oneself: hidden, placed, revealed.
#include "app/lesson/lesson.h"

#include <doctest/doctest.h>

#include "app/window/window.h"
#include "model/text/numbers.h"
#include "tests/support/lesson_class.h"

namespace lesson_place_test {

using namespace tact;

namespace {

constexpr const char* kBeats = "lessons/beats.tactlesson.json";

struct Placing : Class {
    Placing() {
        app.ui.motion = false;
        request_maps(app.ui, app.work, app.shown_map, app.rendered);
        begin(kBeats);
        wait_for_numbers();
        go_to_question(QuestionKind::place);
        wait_for_exact_map();
        settle();
    }

    Tally& tally() { return lesson().tallies[*lesson().step]; }

    Eigen::RowVectorXd place_of_model() {
        const auto& map = app.shown_map.transition;
        const auto row = place_named(*map.shown->request.set, step_of(lesson())->pattern);
        return map.to.row(static_cast<Eigen::Index>(row.value()));
    }
};

}  // namespace

TEST_CASE("place: the pattern is not to be seen in a flat map until the answer is") {
    Placing program;
    CHECK(program.app.shown_map.transition.to.cols() == 2);
    CHECK(program.shows("point:plain"));
    CHECK_FALSE(program.shows("point:AM 80 Hz"));
    program.press_key(key::kPageDown);
    CHECK(program.tally().revealed);
    CHECK(program.shows("point:AM 80 Hz"));
}

TEST_CASE("place: a click puts it there, and how far off that was is told with the answer") {
    Placing program;
    const ImVec2 there = program.at("point:plain").middle();
    program.window.click(there);
    program.settle();
    REQUIRE(program.tally().place);
    // No other click happened.
    CHECK(program.app.work.document.set.vibrations[program.app.work.selection.current].name ==
          "AM 80 Hz");
    const auto& map = program.app.shown_map.transition;
    const auto plain = place_named(*map.shown->request.set, "plain").value();
    const Eigen::RowVector2d put((*program.tally().place)[0], (*program.tally().place)[1]);
    double width = 0.0;
    for (Eigen::Index i = 0; i < map.to.rows(); ++i) {
        width = std::max(width, (map.to.rowwise() - map.to.row(i)).rowwise().norm().maxCoeff());
    }
    CHECK((put - map.to.row(static_cast<Eigen::Index>(plain))).norm() <= 0.01 * width);
    program.press_key(key::kPageDown);
    const double off = place_off_by(program.lesson(), program.app.shown_map).value();
    CHECK(off == doctest::Approx((put - program.place_of_model()).norm() / width));
    const std::string words = "off by " + percent(off) + " of the map's width";
    CHECK(program.at("lesson:answer").value.find(words) != std::string::npos);
    // A vote for the pattern nearest to the place, which is not the model's nearest.
    CHECK(program.at("option:1").value == "1");
    CHECK(score_of(program.lesson()).asked == 1);
    CHECK(score_of(program.lesson()).right == 0);
    // After revealing, the cross stays at its place.
    program.window.click(program.at("point:beats").middle());
    program.settle();
    CHECK((*program.tally().place)[0] == put(0));
}

TEST_CASE("place: Shift and the arrows move the cross, also before a class") {
    Placing program;
    toggle_presenting(lesson_context(program.app), program.lesson());
    program.go_to_question(QuestionKind::place);
    program.wait_for_exact_map();
    program.settle();
    const auto at = program.lesson().step;
    program.press_key(key::kRight, false, true);
    REQUIRE(program.tally().place);
    const MapPlace begun = *program.tally().place;
    program.press_key(key::kRight, false, true);
    program.press_key(key::kUp, false, true);
    CHECK((*program.tally().place)[0] > begun[0]);
    CHECK((*program.tally().place)[1] > begun[1]);
    CHECK(program.lesson().step == at);
    // At the model's own place the error is zero, and the answer right.
    const Eigen::RowVectorXd model = program.place_of_model();
    program.tally().place = MapPlace{model(0), model(1)};
    program.press_key(key::kPageDown);
    CHECK(place_off_by(program.lesson(), program.app.shown_map).value() == doctest::Approx(0.0));
    CHECK(score_of(program.lesson()).right == 1);
}

TEST_CASE("place: the map is as deep as before when the lesson is left") {
    Placing program;
    CHECK(program.app.shown_map.dimensions == 2);
    leave_lesson(lesson_context(program.app), program.lesson());
    CHECK(program.app.shown_map.dimensions == 3);
}

TEST_CASE("place: a sheet's picture does not give it away") {
    const auto lesson = bundled_lesson(kBeats);
    const std::size_t last = lesson->steps.size() - 1;
    REQUIRE(lesson->steps[last].question->kind == QuestionKind::place);
    Lesson told = *lesson;
    told.steps[last].question.reset();
    const std::string hidden = step_picture(*lesson, last);
    CHECK(hidden.find("AM 40 Hz") != std::string::npos);
    CHECK(hidden.find(">AM 80 Hz<") == std::string::npos);
    CHECK(step_picture(told, last).find(">AM 80 Hz<") != std::string::npos);
}

}  // namespace lesson_place_test
