// The ways to begin with an empty set.

#include "app/document/editing.h"
#include "app/workspaces/workspaces.h"
#include "tests/support/program.h"

namespace start_page_test {

using namespace tact;

namespace {

struct Start : Program {
    Start() : Program(PatternSet{}) {
        app.layout = first_layout(Arrangement::design);
        settle();
    }
    const std::vector<Vibration>& all() const { return app.work.document.set.vibrations; }
};

}  // namespace

TEST_CASE("start page: eight cards, one of which is added by a click and undone as one step") {
    Start program;
    REQUIRE(program.shows("pane:Start"));
    CHECK_FALSE(program.shows("pane:Editor"));
    const auto& cards = program.app.pattern_panes.start.cards;
    REQUIRE(cards.size() == 8);
    for (const Vibration& card : cards) {
        CAPTURE(card.name);
        REQUIRE(program.shows("start:" + card.name));
        const Place& pane = program.at("pane:Start");
        const Place& place = program.at("start:" + card.name);
        CHECK(place.min.x >= pane.min.x);
        CHECK(place.max.y <= pane.max.y);
    }
    const std::string name = cards[1].name;
    const auto source = cards[1].source;
    program.click("start:" + name);
    REQUIRE(program.all().size() == 1);
    CHECK(program.all()[0].name == name);
    CHECK(program.all()[0].source == source);
    CHECK_FALSE(program.shows("pane:Start"));
    CHECK(program.shows("pane:Editor"));
    undo(program.app.ui, program.app.work);
    program.settle();
    CHECK(program.shows("pane:Start"));
}

TEST_CASE("start page: its buttons make a pattern, open the chooser and the generator") {
    Start program;
    program.click("start:open");
    CHECK(program.app.ui.chooser.is_open);
    program.press_key(key::kEscape);
    program.click("start:generate");
    CHECK(program.app.ui.dialog == kGenerateDialog);
    program.press_key(key::kEscape);
    program.click("button:new pattern");
    CHECK(program.all().size() == 1);
}

TEST_CASE("start page: it stays out of the other arrangements, and nothing maximises it") {
    Start program;
    program.press_key(key::kF1 + 5);
    CHECK(program.shows("pane:Start"));
    CHECK(program.shows("pane:Patterns"));
    program.click("workspace:Select");
    CHECK_FALSE(program.shows("pane:Start"));
}

}  // namespace start_page_test
