#include "model/rhythm.h"

#include "golden.h"

using namespace tact;

TEST_CASE("rhythm: x starts a note, = holds it, - rests") {
    const auto found = notes({"x=x---x-", 0.125}, 1.0);
    CHECK(found == std::vector<Note>{{0.0, 0.25}, {0.25, 0.125}, {0.75, 0.125}});
}

TEST_CASE("rhythm: no text is one note throughout") {
    CHECK(notes({}, 2.5) == std::vector<Note>{{0.0, 2.5}});
}

TEST_CASE("rhythm: the text repeats to fill the duration, and the last note is cut there") {
    const auto found = notes({"x=-", 0.25}, 1.0);
    CHECK(found == std::vector<Note>{{0.0, 0.5}, {0.75, 0.25}});
}

TEST_CASE("rhythm: all rests are no notes") { CHECK(notes({"----", 0.1}, 1.0).empty()); }

TEST_CASE("rhythm: text that is none is named with the step at fault") {
    CHECK(rhythm_fault("x=x---x-").empty());
    CHECK(rhythm_fault("").empty());
    CHECK(rhythm_fault("xqx") == "step 2 is not one of x, = and -");
    CHECK(rhythm_fault("=x") == "step 1 is =, which must follow x or =");
    CHECK(rhythm_fault("x-=") == "step 3 is =, which must follow x or =");
    CHECK(rhythm_fault(std::string(257, 'x')).find("at most 256") != std::string::npos);
}
