// A class sees all questions of a lesson whole, at whichever edge the card stands.
#include <doctest/doctest.h>

#include <cmath>

#include "app/lesson/lesson.h"
#include "tests/support/lesson_walk.h"

namespace lesson_shown_test {

using namespace tact;

namespace {

constexpr std::array<DockSide, 4> kEdges{DockSide::right, DockSide::bottom, DockSide::left,
                                         DockSide::top};

// While presenting, text grows with the screen: 150 % looks the same on both screens.
const LessonScreen kScreens[] = {
    {{1280.0F, 720.0F}, 1.0F, true},  {{1280.0F, 720.0F}, 1.5F, true},
    {{1280.0F, 720.0F}, 2.0F, true},  {{1280.0F, 720.0F}, 1.0F, false},
    {{1280.0F, 720.0F}, 1.5F, false}, {{1920.0F, 1080.0F}, 1.0F, false},
    {{1920.0F, 1080.0F}, 1.5F, true}};

bool is_within(const Place& inner, const Place& outer) {
    return inner.min.x >= outer.min.x && inner.max.x <= outer.max.x && inner.min.y >= outer.min.y &&
           inner.max.y <= outer.max.y;
}

bool meet(const Place& a, const Place& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// Each option is apart from all others, and inside the card, which is inside the window.
void check_options(const LessonWalk& walk, std::size_t count) {
    const Place card = walk.at("tour");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    CHECK(is_within(card, {{0.0F, 0.0F}, screen, {}}));
    for (std::size_t k = 1; k <= count; ++k) {
        const std::string name = "option:" + std::to_string(k);
        CAPTURE(std::string(name));
        CHECK(is_within(walk.at(name), card));
        for (std::size_t other = 1; other < k; ++other) {
            CHECK_FALSE(meet(walk.at(name), walk.at("option:" + std::to_string(other))));
        }
    }
    // With text twice as large, a small window scrolls to them; the keys still move on.
    if (walk.app.ui.text_scale < 2.0F) {
        CHECK(is_within(walk.at("lesson:move"), card));
        CHECK(is_within(walk.at("tour:back"), card));
    }
}

float left_in_card(const LessonWalk& walk, std::size_t option) {
    return walk.at("option:" + std::to_string(option)).min.x - walk.at("tour").min.x;
}

void check_question(LessonWalk& walk, std::size_t k, DockSide side) {
    const std::size_t count = answers_of(walk.lesson())->questions[k].options.size();
    Tally& tally = walk.lesson().tallies[k];
    tally = {};
    walk.lesson().dock = side;
    go_to_step(lesson_context(walk.app), walk.lesson(), k);
    walk.settle();
    check_options(walk, count);
    const float first = left_in_card(walk, 1);
    const float last = left_in_card(walk, count);
    for (int hand = 0; hand < 12; ++hand) vote(walk.lesson(), 0);
    walk.settle();
    CHECK(left_in_card(walk, 1) == first);
    CHECK(left_in_card(walk, count) == last);
    check_options(walk, count);
    tally.revealed = true;
    walk.settle();
    check_options(walk, count);
    CHECK(is_within(walk.at("lesson:answer"), walk.at("tour")));
}

void check_questions(LessonWalk& walk, const LessonScreen& screen) {
    CAPTURE(screen.size.x);
    CAPTURE(screen.scale);
    CAPTURE(screen.presented);
    walk.show_on(screen);
    for (std::size_t k = 0; k < walk.lesson().lesson->steps.size(); ++k) {
        if (!walk.lesson().lesson->steps[k].question) continue;
        CAPTURE(k);
        for (const DockSide side : kEdges) {
            CAPTURE(std::string(edge_name(side)));
            check_question(walk, k, side);
        }
    }
}

// Frequencies of the peaks of a spectrum: at least a fifth of the largest. Adjacent lines, which
// lie 1 Hz apart for one second, are one bar.
std::vector<double> bars_of(const LiveStages& live) {
    double most = 0.0;
    for (const Component& component : live.neural.components) {
        most = std::max(most, component.amplitude_g);
    }
    std::vector<double> bars;
    double before_hz = -1e9;
    for (const Component& component : live.neural.components) {
        if (component.amplitude_g <= 0.2 * most) continue;
        if (component.frequency_hz > before_hz + 2.0) bars.push_back(component.frequency_hz);
        before_hz = component.frequency_hz;
    }
    return bars;
}

// The axis is logarithmic from 1 to 500 Hz, and takes at least three quarters of the plot.
double least_gap_px(const std::vector<double>& bars, const Place& plot) {
    double least = 1e9;
    for (std::size_t k = 1; k < bars.size(); ++k) {
        const double share = std::log(bars[k] / bars[k - 1]) / std::log(500.0);
        least = std::min(least, 0.75 * share * static_cast<double>(plot.max.x - plot.min.x));
    }
    return least;
}

}  // namespace

TEST_CASE("lesson: bars of a spectrum that a step speaks of stand apart on a small screen" *
          doctest::test_suite("long")) {
    int several = 0;
    for (const char* path : bundled_lesson_paths()) {
        CAPTURE(std::string(path));
        LessonWalk walk(path);
        walk.show_on({{1280.0F, 720.0F}, 1.0F, true});
        for (std::size_t k = 0; k < walk.lesson().lesson->steps.size(); ++k) {
            const LessonStep& step = walk.lesson().lesson->steps[k];
            if (step.view != "spectrum") continue;
            CAPTURE(step.title);
            walk.show_step(k, DockSide::right);
            const std::vector<double> bars = bars_of(*walk.app.physiology.stages);
            REQUIRE_FALSE(bars.empty());
            several += bars.size() > 1 ? 1 : 0;
            CHECK(least_gap_px(bars, walk.at("plot:spectrum")) >= 12.0);
            if (step.partner.empty()) continue;
            const std::vector<double> others = bars_of(*walk.app.physiology.pinned_stages);
            CHECK(least_gap_px(others, walk.at("plot:spectrum pinned")) >= 12.0);
        }
    }
    CHECK(several > 0);
}

TEST_CASE("lesson: every option of every question is seen whole, whatever the edge and the text" *
          doctest::test_suite("long")) {
    for (const char* path : bundled_lesson_paths()) {
        CAPTURE(std::string(path));
        LessonWalk walk(path);
        for (const LessonScreen& screen : kScreens) check_questions(walk, screen);
    }
}

// The smallest screen, with text of 150 %.
TEST_CASE("lesson: so they are in each of its languages" * doctest::test_suite("long")) {
    int further = 0;
    for (const char* path : bundled_lesson_paths()) {
        CAPTURE(std::string(path));
        LessonWalk walk(path);
        const std::vector<std::string> languages = walk.lesson().lesson->languages;
        for (std::size_t k = 1; k < languages.size(); ++k) {
            ++further;
            CAPTURE(languages[k]);
            choose_language(walk.app.ui, walk.lesson(), languages[k]);
            walk.wait_for_numbers();
            REQUIRE(shown_language(walk.lesson()) == k);
            check_questions(walk, {{1280.0F, 720.0F}, 1.5F, true});
        }
    }
    CHECK(further >= 18);
}

}  // namespace lesson_shown_test
