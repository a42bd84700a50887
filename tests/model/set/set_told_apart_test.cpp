#include "model/set/set_told_apart.h"

#include <doctest/doctest.h>

#include "model/set/felt_versions.h"
#include "model/text/numbers.h"
#include "model/told_apart/told_apart_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/three_tones.h"

namespace set_told_apart_test {

using namespace tact;

namespace {

PatternSet four() {
    PatternSet set;
    for (const char* name : {"a", "b", "c", "d"}) {
        set.vibrations.push_back(named_tone(name, 100.0 + 30.0 * (name[0] - 'a')));
    }
    return set;
}

const Dissimilarity kPm{4, {4, 20, 40, 9, 12, 6}};

OddAnswer answer(const PatternSet& set, std::size_t a, std::size_t b, bool is_right) {
    const OddOneOut trial{set.vibrations[a].name, set.vibrations[b].name, kPm(a, b), 1, false};
    return {trial, is_right ? 1 : 2, 2.0};
}

// Twelve answers of a and b, eight of a and d, and what is said of them.
PatternSet asked() {
    PatternSet set = four();
    std::vector<OddAnswer> answers;
    for (int k = 0; k < 12; ++k) answers.push_back(answer(set, 0, 1, k % 2 == 0));
    for (int k = 0; k < 8; ++k) answers.push_back(answer(set, 0, 3, true));
    ToldApart about;
    about.device = "phone Kim (web vibration)";
    about.person = "Kim";
    about.date = "2026-11-28T21:12:53Z";
    set.told_apart = {noted_trials(set, about, answers)};
    return set;
}

Pattern& pattern(PatternSet& set, std::size_t k) {
    return std::get<Pattern>(set.vibrations[k].source);
}

}  // namespace

TEST_CASE("trials of a set: they are noted with the versions of what was played") {
    const PatternSet set = asked();
    const ToldApart& told = set.told_apart[0];
    CHECK(told.device == "phone Kim (web vibration)");
    CHECK(told.answers.size() == 20);
    CHECK(told.patterns == std::vector<std::string>{"a", "b", "d"});
    REQUIRE(told.versions.size() == 3);
    CHECK(told.versions[2] == version_of(set.vibrations[3]));
}

TEST_CASE("trials of a set: beside a verdict they are said in one sentence") {
    const PatternSet set = asked();
    const ToldApartResults results = results_of(set.told_apart[0]);
    const std::string share = percent(predicted_share(results.posterior, 9.0).share);
    CHECK(told_apart_words(set, kPm, 9.0) ==
          "On phone Kim (web vibration), pairs at PM 9 were told apart in about " + share +
              " of trials (one person, 20 trials).");
    CHECK(contains(told_apart_words(set, kPm, 2.0), "less than any that was asked, may be"));
    const std::string help = told_apart_help(set, kPm);
    CHECK(contains(help, "14 of 20 trials were right: 70 %"));
    CHECK(contains(help, threshold_words(results)));
    CHECK(contains(help,
                   "Measured on one person, on one device: Kim, 2026-11-28T21:12:53Z. It is not "
                   "part of PM."));
}

TEST_CASE("trials of a set: nothing is said where nothing was measured") {
    CHECK(told_apart_words(four(), kPm, 9.0).empty());
    CHECK(told_apart_help(four(), kPm).empty());
    CHECK(told_apart_words(asked(), kPm, 0.0).empty());
    CHECK(told_apart_words(asked(), {3, {1, 2, 3}}, 9.0).empty());  // PM of another set
    PatternSet few = asked();
    few.told_apart[0].answers.resize(9);
    CHECK(told_apart_words(few, kPm, 9.0).empty());
    PatternSet unrecorded = asked();
    unrecorded.told_apart[0].versions.assign(3, "");
    CHECK(told_apart_words(unrecorded, kPm, 9.0).empty());
}

TEST_CASE(
    "trials of a set: an edited pattern takes its answers along, and looks or a name do not") {
    PatternSet set = asked();
    set.vibrations[3].colour = "#123456";
    rename_in(set.told_apart[0], "d", "e");
    set.vibrations[3].name = "e";
    CHECK(still_told(set, set.told_apart[0], kPm).answers.size() == 20);
    pattern(set, 3).amplitude_g *= 1.01;
    CHECK(still_told(set, set.told_apart[0], kPm).answers.size() == 12);
    CHECK(contains(told_apart_words(set, kPm, 4.0), "(one person, 12 trials)"));
    CHECK(contains(told_apart_help(set, kPm),
                   "8 trials do not count any more: a pattern was edited or removed since."));
    pattern(set, 0).amplitude_g *= 1.01;
    CHECK(told_apart_words(set, kPm, 9.0).empty());
    CHECK(set.told_apart[0].answers.size() == 20);  // they are kept: an undo brings them back
    pattern(set, 0) = pattern(set, 3) = Pattern{};
    set.vibrations[3] = four().vibrations[3];
    set.vibrations[0] = four().vibrations[0];
    CHECK(still_told(set, set.told_apart[0], kPm).answers.size() == 12);  // d is called e there
}

TEST_CASE("trials of a set: a removed pattern takes its answers along, an added one moves PM") {
    PatternSet set = asked();
    set.vibrations.pop_back();
    const Dissimilarity of_three{3, {1, 3, 2}};
    const ToldApart still = still_told(set, set.told_apart[0], of_three);
    REQUIRE(still.answers.size() == 12);
    CHECK(still.answers[0].trial.pm == 1.0);  // of the pair now, and no longer 4
    PatternSet more = asked();
    more.vibrations.insert(more.vibrations.begin(), named_tone("new", 60.0));
    const Dissimilarity of_five{5, {1, 2, 3, 4, 8, 40, 80, 18, 24, 12}};
    const ToldApart moved = still_told(more, more.told_apart[0], of_five);
    CHECK(moved.answers[0].trial.pm == 8.0);
    CHECK(moved.answers[19].trial.pm == 80.0);
    // Every PM is twice what it was, and so is the threshold.
    CHECK(results_of(moved).threshold_pm ==
          doctest::Approx(2.0 * results_of(asked().told_apart[0]).threshold_pm).epsilon(1e-10));
}

TEST_CASE("trials of a set: the newest that still say something are taken, people before none") {
    PatternSet set = asked();
    ToldApart older = set.told_apart[0];
    older.device = "phone Lee";
    older.date = "2026-11-27T23:59:59Z";
    ToldApart simulated = set.told_apart[0];
    simulated.device = "no device";
    simulated.synthetic = true;
    simulated.date = "2026-12-01T00:00:00Z";
    ToldApart few = set.told_apart[0];
    few.answers.resize(5);
    few.date = "2026-12-02T00:00:00Z";
    set.told_apart = {simulated, set.told_apart[0], older, few};
    CHECK(newest_told(set, kPm)->place == 1);
    set.told_apart.erase(set.told_apart.begin() + 1);
    CHECK(told_apart_words(set, kPm, 9.0).starts_with("On phone Lee, "));
    set.told_apart = {simulated};
    CHECK(contains(told_apart_words(set, kPm, 9.0), "(simulated, 20 trials)"));
    CHECK(contains(told_apart_help(set, kPm), "Simulated: no person was asked"));
}

TEST_CASE("trials of a set: pairs that are at PM 0 now are left out") {
    const PatternSet set = asked();
    Dissimilarity pm = kPm;
    pm.condensed[0] = 0.0;
    CHECK(still_told(set, set.told_apart[0], pm).answers.size() == 8);
    pm.condensed[2] = std::numeric_limits<double>::quiet_NaN();
    CHECK(still_told(set, set.told_apart[0], pm).answers.empty());
}

}  // namespace set_told_apart_test
