// Who counts, decided in the window: left out for a reason that the study's folder keeps, rules on
// how people answered, and what each one goes by.
#include "app/study/study.h"
#include "model/io/people/exclusions_file.h"
#include "tests/support/quick_study.h"
#include "tests/support/temporary_folder.h"

namespace who_counts_window_test {

using namespace tact;

namespace {

PatternSet twice_asked() {
    PatternSet set = quick_study();
    set.study.repetitions = 2;
    return set;
}

// Three simulated participants, on screen.
struct StudyOfThree : StudyWindow {
    TemporaryFolder folder;

    StudyOfThree() : StudyWindow(twice_asked()) {
        set_study_folder(app.work, app.studying, folder.path / "people");
        compute_map();
        press('4', true);
        for (int k = 1; k <= 3; ++k) {
            click("button:simulate");
            wait_for("participant:synthetic P" + std::to_string(k));
        }
    }

    std::string state_of(int person) const {
        return at("participant:synthetic P" + std::to_string(person)).value;
    }
};

}  // namespace

TEST_CASE("study window: who is left out needs a reason, is named with it, and can count again") {
    StudyOfThree program;
    CHECK(contains(program.at("study:agreement").value, "3 of 3 participants count"));
    program.click("link:leave out synthetic P2");
    // Without a reason nothing is done.
    program.type("  ");
    program.click("button:choose");
    CHECK(program.shows("leave out:because"));
    program.click("leave out:because");
    program.type("wore gloves");
    program.click("button:choose");
    program.wait_for("link:count again synthetic P2");
    CHECK(contains(program.state_of(2), "wore gloves"));
    CHECK(contains(program.at("study:agreement").value, "2 of 3 participants count"));
    const auto kept = read_exclusions(program.folder.path / "people");
    REQUIRE(kept->size() == 1);
    CHECK(kept->front().participant == "synthetic P2");
    CHECK(contains(kept->front().because, "wore gloves"));
    program.click("link:count again synthetic P2");
    program.wait_for("link:leave out synthetic P2");
    CHECK(read_exclusions(program.folder.path / "people")->empty());
    CHECK(contains(program.at("study:agreement").value, "3 of 3 participants count"));
}

TEST_CASE("study window: Esc leaves everybody as they were") {
    StudyOfThree program;
    program.click("link:leave out synthetic P1");
    program.type("a reason");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("leave out:because"));
    CHECK(read_exclusions(program.folder.path / "people")->empty());
}

TEST_CASE("study window: a rule on conduct is off until it is switched on, and says who falls") {
    StudyOfThree program;
    CHECK(program.at("link:conduct rules").value == "Rules...");
    program.click("link:conduct rules");
    CHECK(program.at("check:repeat_rho").value == "off");
    program.click("check:repeat_rho");
    // Nobody agrees so well with themselves.
    program.app.studying.rule.who.conduct.repeat_rho = 1.0;
    program.click("button:close");
    program.wait_for("participant:synthetic P1");
    CHECK(program.at("link:conduct rules").value == "1 rule...");
    CHECK(contains(program.at("study:agreement").value, "0 of 3 participants count"));
    CHECK(contains(program.state_of(3), "repetitions"));
    program.click("link:conduct rules");
    program.click("check:repeat_rho");
    program.click("button:close");
    program.wait_for("link:leave out synthetic P3");
    CHECK(contains(program.at("study:agreement").value, "3 of 3 participants count"));
}

TEST_CASE("study window: everyone who counts has a word on what they go by") {
    StudyOfThree program;
    for (int k = 1; k <= 3; ++k) CHECK(program.shows("goes by:synthetic P" + std::to_string(k)));
    program.click("link:leave out synthetic P1");
    program.type("late");
    program.click("button:choose");
    program.wait_for("link:count again synthetic P1");
    CHECK_FALSE(program.shows("goes by:synthetic P1"));
    CHECK(program.shows("goes by:synthetic P3"));
}

}  // namespace who_counts_window_test
