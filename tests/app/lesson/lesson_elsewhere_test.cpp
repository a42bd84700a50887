// Votes from a class's own devices, in addition to hands.
#include "app/lesson/lesson.h"
#include "tests/support/lesson_class.h"

namespace lesson_elsewhere_test {

using namespace tact;

namespace {

// A lesson at its first question.
struct Asking : Class {
    Asking() {
        begin(kTourLesson);
        wait_for_numbers();
        go_to_question();
    }

    Tally& tally() { return lesson().tallies[*lesson().step]; }
};

}  // namespace

TEST_CASE(
    "lesson: who is asked elsewhere hears neither the answer nor a placeholder before it is "
    "revealed" *
    doctest::test_suite("long")) {
    Asking asking;
    const auto asked = question_in_words(asking.lesson());
    REQUIRE(asked);
    CHECK(asked->ask != "");
    CHECK(asked->ask.find('{') == std::string::npos);
    CHECK(asked->options.size() > 1);
    CHECK_FALSE(asked->is_revealed);
    CHECK(asked->right.empty());
    CHECK(asked->reveal.empty());
    asking.tally().revealed = true;
    const auto revealed = question_in_words(asking.lesson());
    CHECK(revealed->is_revealed);
    CHECK_FALSE(revealed->right.empty());
    CHECK(revealed->reveal.find('{') == std::string::npos);
}

TEST_CASE("lesson: votes from elsewhere are counted besides hands, once, and until the reveal" *
          doctest::test_suite("long")) {
    Asking asking;
    vote(asking.lesson(), 0);
    count_elsewhere(asking.lesson(), {2, 1});
    count_elsewhere(asking.lesson(), {2, 1});
    CHECK(asking.tally().votes[0] == 3);
    CHECK(asking.tally().votes[1] == 1);
    count_elsewhere(asking.lesson(), {1, 2});  // one person changed their mind
    CHECK(asking.tally().votes[0] == 2);
    CHECK(asking.tally().votes[1] == 2);
    asking.tally().revealed = true;
    count_elsewhere(asking.lesson(), {9, 9});
    CHECK(asking.tally().votes[0] == 2);
}

}  // namespace lesson_elsewhere_test
