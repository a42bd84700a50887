#include "app/document/workspace.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace history_test {

using namespace tact;

namespace {

template <class Value>
bool commit(History<Value>& history, const Value& before, const Value& after, const char* label) {
    return history.commit(std::make_shared<const Value>(before),
                          std::make_shared<const Value>(after), label);
}

}  // namespace

TEST_CASE("history: undo goes back value by value and redo forward again") {
    History<std::string> history;
    REQUIRE(commit<std::string>(history, "", "a", "Type a"));
    REQUIRE(commit<std::string>(history, "a", "ab", "Type b"));
    CHECK(*history.undo() == "a");
    CHECK(history.undo()->empty());
    CHECK(history.undo() == nullptr);
    CHECK(*history.redo() == "a");
    CHECK(*history.redo() == "ab");
    CHECK(history.redo() == nullptr);
}

TEST_CASE("history: its steps can be read, and how many of them are done") {
    History<int> history;
    REQUIRE(commit(history, 1, 2, "Double"));
    REQUIRE(commit(history, 2, 3, "Add one"));
    REQUIRE(history.undo() != nullptr);
    CHECK(history.size() == 2);
    CHECK(history.done() == 1);
    CHECK(history.label(0) == "Double");
    CHECK(history.label(1) == "Add one");
}

TEST_CASE("history: a gesture that changes nothing is no step and keeps redo") {
    History<int> history;
    REQUIRE(commit(history, 1, 2, "Double"));
    REQUIRE(history.undo() != nullptr);
    CHECK_FALSE(commit(history, 1, 1, "Nothing"));
    REQUIRE(history.redo_label() != nullptr);
    CHECK(*history.redo() == 2);
}

TEST_CASE("history: a new step after undo drops what could be redone") {
    History<int> history;
    commit(history, 1, 2, "First");
    commit(history, 2, 3, "Second");
    history.undo();
    commit(history, 2, 9, "Other");
    CHECK(history.redo() == nullptr);
    CHECK(*history.undo_label() == "Other");
    CHECK(*history.undo() == 2);
    CHECK(*history.undo() == 1);
}

TEST_CASE("history: the last hundred gestures can be undone, and memory has a bound") {
    static_assert(kHistorySteps >= 100);
    History<int> history;
    for (int i = 0; i < 1000; ++i) commit(history, i, i + 1, "Count");
    std::size_t undone = 0;
    int value = 1000;
    while (const auto state = history.undo()) {
        CHECK(*state == value - 1);
        value = *state;
        ++undone;
    }
    CHECK(undone == kHistorySteps);
}

TEST_CASE("history: neighbouring steps share the value between them") {
    using State = History<std::vector<double>>::State;
    const State first = std::make_shared<const std::vector<double>>(1, 1.0);
    const State second = std::make_shared<const std::vector<double>>(1, 2.0);
    const State third = std::make_shared<const std::vector<double>>(1, 3.0);
    History<std::vector<double>> history;
    history.commit(first, second, "First");
    history.commit(second, third, "Second");
    CHECK(second.use_count() == 3);  // ours and one in each step: no copies
    CHECK(history.undo() == second);
    history.undo();
    CHECK(history.redo() == second);
}

TEST_CASE("history: a change that was never committed is not brought back by undo") {
    History<int> history;
    commit(history, 1, 2, "First");
    commit(history, 5, 6, "From elsewhere");
    CHECK(*history.undo() == 5);
    CHECK(*history.undo() == 1);
}

TEST_CASE("history: labels name what undo and redo would do") {
    History<int> history;
    CHECK(menu_text("Undo", history.undo_label()) == "Undo");
    commit(history, 1, 2, "Change amplitude of L-4-full");
    CHECK(menu_text("Undo", history.undo_label()) == "Undo change amplitude of L-4-full");
    CHECK(history.redo_label() == nullptr);
    history.undo();
    CHECK(menu_text("Redo", history.redo_label()) == "Redo change amplitude of L-4-full");
    const std::string acronym = "CSV import";
    CHECK(menu_text("Undo", &acronym) == "Undo CSV import");
}

TEST_CASE("history: cleared, there is nothing to undo or redo") {
    History<int> history;
    commit(history, 1, 2, "First");
    commit(history, 2, 3, "Second");
    history.undo();
    history.clear();
    CHECK(history.undo() == nullptr);
    CHECK(history.redo() == nullptr);
}

}  // namespace history_test
