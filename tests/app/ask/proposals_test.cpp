// Proposed patterns in the map: neighbours, tracks, and the card of the closest pattern.
#include "app/ask/ask.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace proposals_test {

using namespace tact;

namespace {

template <class Arrived>
void frames_until(Program& program, Arrived arrived) {
    const auto until = end_of_patience();
    while (!arrived()) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
}

struct Mapped : Program {
    Mapped() : Program(short_patterns(5)) {
        app.ui.motion = false;
        compute_map();
        settle();
    }
};

}  // namespace

TEST_CASE("vary: V shows eight neighbours, a click takes one, one step takes it back") {
    Mapped program;
    const PatternSet before = program.app.work.document.set;
    program.press('v');
    CHECK(program.app.proposals.varied == "p1");
    frames_until(program, [&] { return program.shows("proposal:8"); });
    const auto found = found_variants(program.app.proposals);
    REQUIRE(found->patterns.size() == 8);
    CHECK(program.at("vary:found").value == "8");
    take_variant(program.app.ui, program.app.work, program.app.proposals, 2);
    CHECK(program.pattern(0) == found->patterns[2]);
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("vary: V again shows others, Esc leaves the pattern as it is") {
    Mapped program;
    program.press('v');
    frames_until(program, [&] { return program.shows("proposal:8"); });
    const auto first = found_variants(program.app.proposals)->patterns;
    program.press('v');
    frames_until(program, [&] { return found_variants(program.app.proposals) != nullptr; });
    CHECK_FALSE(found_variants(program.app.proposals)->patterns == first);
    program.press_key(key::kEscape);
    CHECK(program.app.proposals.varied.empty());
    CHECK_FALSE(program.shows("proposal:1"));
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("track: resting on a slider shows where it leads, with the numbers of its ends") {
    Mapped program;
    program.hover(program.at("slider:amplitude_g").middle());
    frames_until(program, [&] { return program.shows("track:13"); });
    INFO(program.at("track:1").value);
    CHECK(program.at("track:1").value.starts_with("0 g"));
    CHECK(program.at("track:13").value.starts_with("4 g"));
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("neighbour card: it names the closest, and its words lead to it") {
    Mapped program;
    const Dissimilarity& pm = program.app.shown_map.transition.shown->prediction.pm;
    std::size_t closest = 1;
    for (std::size_t k = 2; k < 5; ++k) {
        if (pm(0, k) < pm(0, closest)) closest = k;
    }
    const std::string name = "p" + std::to_string(closest + 1);
    CHECK(program.at("neighbour:name").value == name);
    CHECK(program.shows("neighbour:verdict"));
    program.click("neighbour:why closest");
    CHECK(program.app.layout.bench == BenchTab::why);
    CHECK(program.app.work.selection.partner == name);
    program.click("neighbour:separate closest");
    CHECK(program.app.layout.bench == BenchTab::subset);
    CHECK(program.app.picking.opened->first == "p1");
    CHECK(program.app.picking.opened->second == name);
}

TEST_CASE("map: saved with the set, it is opened as it lay") {
    Mapped program;
    const Eigen::MatrixXd lay = program.app.shown_map.transition.to;
    PatternSet turned = program.app.work.document.kept().set;
    REQUIRE(turned.map_places.at.size() == 5);
    for (auto& [name, at] : turned.map_places.at) {
        at[0] = -at[0];  // mirrored
    }
    Program again(turned);
    again.app.ui.motion = false;
    again.compute_map();
    Eigen::MatrixXd mirrored = lay;
    mirrored.col(0) *= -1.0;
    CHECK((again.app.shown_map.transition.to - mirrored).norm() < 1e-3 * lay.norm());
    // A document that was only opened is saved unchanged, to the last digit.
    CHECK(again.app.work.document.kept().set.map_places.at == turned.map_places.at);
}

}  // namespace proposals_test
