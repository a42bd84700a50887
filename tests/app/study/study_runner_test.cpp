#include "app/study/study.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"

namespace study_runner_test {

using namespace tact;
using What = StudyEvent::What;

namespace {

constexpr std::size_t kPatterns = 4;
constexpr double kDurationS = 0.5;

StudyRecord new_record(StudyKind kind = StudyKind::pairwise) {
    StudyRecord record;
    record.header.kind = kind;
    record.header.patterns = {"a", "b", "c", "d"};
    record.header.design.repetitions = 2;
    record.header.design.attention_pairs = 1;
    record.header.design.break_every = 5;
    record.header.seed = 3;
    record.header.participant.code = "P1";
    return record;
}

// A participant, their hands and the disk.
struct Person {
    StudyRun run;
    double now_s = 100.0;
    std::string file;
    std::vector<std::size_t> felt;
    std::vector<double> rests_s;  // before each of them
    bool has_left = false;
    bool is_disk_full = false;

    explicit Person(StudyRecord record = new_record())
        : run(study_run(std::move(record), std::vector<double>(kPatterns, kDurationS))) {}

    void act(What what, std::size_t index = 0, double value = 0.0) {
        StudyStep step = stepped(run, {what, index, value, {}, "then"}, now_s);
        run = std::move(step.run);
        if (step.actions.play) felt.push_back(*step.actions.play);
        if (step.actions.play) rests_s.push_back(step.actions.rest_s);
        has_left = has_left || step.actions.left;
        std::optional<std::string> line = step.actions.line;
        if (step.actions.begin_file) line = header_line(run.record.header);
        if (!line) return;
        if (!is_disk_full) file += *line + "\n";
        run = stepped(run, {is_disk_full ? What::not_saved : What::saved, 0, 0, "full", {}}, now_s)
                  .run;
    }
    void wait(double seconds) {
        now_s += seconds;
        act(What::tick);
    }
    void feel(std::size_t button) {
        act(What::play, button);
        wait(kDurationS + 1.0);
    }
    void train() {
        act(What::go_on);  // agrees
        act(What::go_on);  // has read the instructions
        for (std::size_t button = 0; button < kPatterns; ++button) feel(button);
        act(What::go_on);
    }
    void answer(double similarity) {
        feel(0);
        feel(1);
        act(What::rate, 0, similarity);
        act(What::go_on);
        if (run.page == StudyPage::rest) act(What::go_on);
    }
};

}  // namespace

TEST_CASE("study runner: from the consent to the end, every answer in the file in order") {
    Person person;
    CHECK(person.run.page == StudyPage::consent);
    person.train();
    CHECK(person.felt == person.run.training);
    std::vector<Trial> shown;
    while (person.run.page == StudyPage::trial) {
        shown.push_back(person.run.trial);
        person.answer(static_cast<double>(shown.size()));
        REQUIRE(shown.size() < 100);
    }
    CHECK(person.run.page == StudyPage::finished);
    CHECK(shown == trial_list({kPatterns, 2, 1, 3}));
    const auto record = parse_study(person.file, "file");
    REQUIRE(record);
    REQUIRE(record->answers.size() == 13);
    for (std::size_t k = 0; k < 13; ++k) {
        CHECK(record->answers[k].trial == shown[k]);
        CHECK(record->answers[k].similarity == static_cast<double>(k + 1));
        CHECK(record->answers[k].plays_left == 1);
        CHECK(record->answers[k].response_s == doctest::Approx(3.0));
    }
    CHECK(record->header.consented);
    person.act(What::go_on);
    CHECK(person.has_left);
}

TEST_CASE("study runner: every pattern must be felt in the training, with a rest after each") {
    Person person;
    person.act(What::go_on);
    person.act(What::go_on);
    REQUIRE(person.run.page == StudyPage::training);
    person.act(What::play, 2);
    person.act(What::play, 1);  // too early
    person.wait(kDurationS + 0.5);
    person.act(What::play, 1);  // in the rest, for its end
    CHECK(person.felt.size() == 2);
    CHECK(person.rests_s == std::vector<double>{0.0, 1.0});
    CHECK(person.run.playing_until_s - person.now_s == doctest::Approx(0.5 + kDurationS));
    person.wait(0.5 + kDurationS - 0.01);
    CHECK(person.run.playing);
    person.wait(2.0);
    CHECK_FALSE(may_go_on(person.run, person.now_s));
    person.act(What::go_on);
    CHECK(person.run.page == StudyPage::training);
    person.feel(0);
    person.feel(3);
    CHECK(may_go_on(person.run, person.now_s));
}

TEST_CASE("study runner: the slider opens when both were felt to the end") {
    Person person;
    person.train();
    person.act(What::rate, 0, 50.0);
    CHECK_FALSE(person.run.similarity);
    person.feel(0);
    person.feel(0);
    CHECK_FALSE(may_rate(person.run, person.now_s));
    person.act(What::play, 1);
    CHECK_FALSE(may_rate(person.run, person.now_s));
    person.wait(kDurationS);
    CHECK(may_rate(person.run, person.now_s));
    CHECK_FALSE(may_go_on(person.run, person.now_s));  // the slider was not moved yet
    CHECK(may_play(person.run, person.now_s));         // it waits for the end of the gap
    person.act(What::rate, 0, 140.0);
    CHECK(person.run.similarity == 100.0);
    person.wait(1.0);
    person.feel(1);  // as often as one likes
    person.act(What::go_on);
    CHECK(person.run.record.answers.back().plays_left == 2);
    CHECK(person.run.record.answers.back().plays_right == 2);
}

TEST_CASE("study runner: what the disk does not take was not answered") {
    Person person;
    person.train();
    person.is_disk_full = true;
    const Trial shown = person.run.trial;
    person.answer(30.0);
    CHECK(person.run.trial == shown);
    CHECK(person.run.similarity == 30.0);
    CHECK(person.run.trouble == "full");
    CHECK(person.run.record.answers.empty());
    person.is_disk_full = false;
    person.act(What::go_on);
    CHECK(person.run.trouble.empty());
    CHECK(person.run.record.answers.size() == 1);
    CHECK(parse_study(person.file, "file")->answers.size() == 1);
}

TEST_CASE("study runner: killed in any trial, it goes on with that trial") {
    for (std::size_t killed_after = 0; killed_after < 13; ++killed_after) {
        CAPTURE(killed_after);
        Person first;
        first.train();
        for (std::size_t k = 0; k < killed_after; ++k) first.answer(50.0);
        const Trial on_screen = first.run.trial;
        Person again(*parse_study(first.file, "file"));
        CHECK(again.run.page == StudyPage::instructions);
        again.act(What::go_on);
        if (killed_after == 0) {  // nothing was rated: the training again
            for (std::size_t button = 0; button < kPatterns; ++button) again.feel(button);
            again.act(What::go_on);
        }
        REQUIRE(again.run.page == StudyPage::trial);
        CHECK(again.run.trial == on_screen);
        CHECK(again.file.empty());  // the header is there already
    }
}

TEST_CASE("study runner: Esc silences and asks; the pause is not counted as thinking") {
    Person person;
    person.train();
    person.feel(0);
    person.act(What::play, 1);
    person.act(What::ask);
    CHECK(person.run.is_asking);
    CHECK_FALSE(person.run.playing);
    person.act(What::play, 1);
    person.act(What::go_on);
    CHECK(person.felt.size() == kPatterns + 2);
    person.wait(600.0);
    person.act(What::stay);
    person.feel(1);
    person.act(What::rate, 0, 10.0);
    person.act(What::go_on);
    CHECK(person.run.record.answers.back().response_s < 5.0);
    person.act(What::ask);
    person.act(What::leave);
    CHECK(person.has_left);
}

TEST_CASE("study runner: a break comes after so many trials, not at the end") {
    Person person;
    person.train();
    int breaks = 0;
    for (int k = 0; k < 13; ++k) {
        person.feel(0);
        person.feel(1);
        person.act(What::rate, 0, 1.0);
        person.act(What::go_on);
        if (person.run.page != StudyPage::rest) continue;
        ++breaks;
        person.act(What::go_on);
    }
    CHECK(breaks == 2);
    CHECK(person.run.page == StudyPage::finished);
}

TEST_CASE("study runner: time left follows the pace, and ends at nothing") {
    Person person;
    person.train();
    const double expected = minutes_left(person.run);
    CHECK(expected == doctest::Approx(13 * 16.0 / 60.0).epsilon(0.05));
    for (int k = 0; k < 6; ++k) person.answer(50.0);
    CHECK(minutes_left(person.run) == doctest::Approx(7 * 3.0 / 60.0).epsilon(0.01));
    for (int k = 0; k < 7; ++k) person.answer(50.0);
    CHECK(minutes_left(person.run) == 0.0);
}

TEST_CASE("study runner: without a code nobody takes part") {
    StudyRecord record = new_record();
    record.header.participant.code = " ";
    Person person(record);
    person.act(What::go_on);
    CHECK(person.run.page == StudyPage::consent);
    CHECK(person.file.empty());
    person.run.record.header.participant.code = "P1";
    person.is_disk_full = true;  // or the code is taken
    person.act(What::go_on);
    CHECK(person.run.page == StudyPage::consent);
    CHECK(person.run.trouble == "full");
}

TEST_CASE("study runner: sorting asks for the free choice, then for the given numbers of groups") {
    StudyRecord record = new_record(StudyKind::sorting);
    record.header.design.groups = {0, 2};
    Person person(record);
    person.act(What::go_on);
    person.act(What::go_on);
    REQUIRE(person.run.page == StudyPage::sorting);
    CHECK(person.run.asked_groups == 0);
    for (std::size_t k = 0; k < 3; ++k) person.act(What::put, k, k == 1 ? 7.0 : 2.0);
    CHECK(unsorted_count(person.run) == 1);
    CHECK_FALSE(may_go_on(person.run, person.now_s));
    person.act(What::put, 3, 9.0);
    person.act(What::put, 3, -1.0);
    CHECK(unsorted_count(person.run) == 1);
    person.act(What::put, 3, 9.0);
    person.wait(40.0);
    person.act(What::go_on);
    CHECK(answers_given(person.run.record) == 0);  // nothing was felt
    for (std::size_t k = 0; k < kPatterns; ++k) {
        CHECK(unfelt_count(person.run) == kPatterns - k);
        CHECK_FALSE(may_go_on(person.run, person.now_s));
        person.feel(k);
    }
    person.feel(2);
    person.act(What::go_on);
    REQUIRE(person.run.page == StudyPage::sorting);
    CHECK(person.run.record.sortings[0].plays == std::vector<int>{1, 1, 2, 1});
    CHECK(person.run.asked_groups == 2);
    CHECK(person.run.record.sortings[0].groups == Sorting{0, 1, 0, 2});
    for (std::size_t k = 0; k < 4; ++k) person.act(What::put, k, k == 0 ? 0.0 : 1.0);
    CHECK(filled_groups(person.run) == 2);
    person.act(What::put, 3, 2.0);
    CHECK_FALSE(may_go_on(person.run, person.now_s));  // three groups, two were asked for
    person.act(What::put, 3, 1.0);
    person.act(What::go_on);
    CHECK(person.run.page == StudyPage::finished);
    const auto read = parse_study(person.file, "file");
    REQUIRE(read);
    CHECK(read->sortings.size() == 2);
    CHECK(read->sortings[0].plays == std::vector<int>{1, 1, 2, 1});
    CHECK(read->sortings[1].plays == std::vector<int>{0, 0, 0, 0});
    CHECK(felt_of(*read, 0) == Felt::whole);
    CHECK(felt_of(*read, 1) == Felt::whole);  // they were felt in the round before
    StudyRecord blind = *read;
    blind.sortings[0].plays[1] = 0;
    CHECK(felt_of(blind, 0) == Felt::in_part);
    CHECK(felt_of(blind, 1) == Felt::in_part);
    for (SortingAnswer& old : blind.sortings) old.plays.clear();
    CHECK(felt_of(blind, 1) == Felt::whole);  // files of before do not say
    CHECK(read->sortings[1].groups == Sorting{0, 1, 1, 1});
}

TEST_CASE("study runner: a pattern counts as felt at its end, and not when it was cut short") {
    Person person;
    person.train();
    const auto plays = [&] {
        return std::pair(person.run.given.plays_left, person.run.given.plays_right);
    };
    person.act(What::play, 0);
    CHECK(plays() == std::pair(0, 0));
    person.wait(0.6 * kDurationS);
    person.act(What::ask);
    person.act(What::stay);
    CHECK(plays() == std::pair(0, 0));
    person.wait(2.0);
    person.feel(1);
    CHECK(plays() == std::pair(0, 1));
    CHECK_FALSE(may_rate(person.run, person.now_s));  // half of A is not A
    person.act(What::play, 0);
    person.wait(0.6 * kDurationS);
    person.act(What::cut_short);
    CHECK(person.run.feels_again);
    person.wait(2.0);
    CHECK_FALSE(may_rate(person.run, person.now_s));
    person.feel(0);
    CHECK_FALSE(person.run.feels_again);
    CHECK(plays() == std::pair(1, 1));
    person.act(What::rate, 0, 30.0);
    person.act(What::go_on);
    const PairAnswer& answer = person.run.record.answers.back();
    CHECK(answer.left.broken == 2);
    CHECK(answer.right.broken == 0);
    CHECK(answer.plays_left == 1);
}

TEST_CASE(
    "study runner: after three cuts in a row the experimenter is called, and all are counted") {
    Person person;
    person.act(What::go_on);
    person.act(What::go_on);
    const auto cut = [&] {
        person.act(What::play, 0);
        person.wait(0.6 * kDurationS);
        person.act(What::cut_short);
        person.wait(2.0);
    };
    for (int k = 1; k <= kCallAfter; ++k) {
        CHECK(person.run.cut_short < kCallAfter);
        cut();
        CHECK(person.run.cut_short == k);
    }
    CHECK(person.run.cut_short >= kCallAfter);
    person.feel(0);
    CHECK(person.run.cut_short == 0);
    CHECK(person.run.cut_short_in_all == 3);
    cut();
    CHECK(person.run.cut_short_in_all == 4);
    CHECK(person.run.broken_in_training == 4);
}

TEST_CASE("study runner: the file keeps what was cut short, in the training too") {
    Person person;
    person.act(What::go_on);
    person.act(What::go_on);
    person.act(What::play, 0);
    person.wait(0.6 * kDurationS);
    person.act(What::cut_short);
    person.wait(2.0);
    for (std::size_t k = 0; k < person.run.training.size(); ++k) person.feel(k);
    person.act(What::go_on);
    REQUIRE(person.run.page == StudyPage::trial);
    person.answer(50.0);
    person.answer(60.0);
    REQUIRE(person.run.record.answers.size() == 2);
    CHECK(person.run.record.answers[0].broken_in_training == 1);
    CHECK(person.run.record.answers[1].broken_in_training == 0);
    CHECK(cut_short_plays(person.run.record) == 1);
}

TEST_CASE("study runner: what its device still plays is not over when its time is") {
    Person person;
    person.train();
    person.act(What::play, 0);
    person.now_s += kDurationS;
    person.act(What::plays_on, 0, 0.3);
    CHECK(person.run.playing);
    CHECK_FALSE(may_play(person.run, person.now_s));
    person.wait(0.2);
    CHECK(person.run.given.plays_left == 0);
    person.wait(0.2);
    CHECK(person.run.given.plays_left == 1);
    // The gap begins then.
    const double gap_s = person.run.record.header.design.gap_s;
    CHECK(person.run.quiet_until_s - person.now_s == doctest::Approx(gap_s - 0.1));
    // Stopped, nothing but the clock keeps the gap.
    person.act(What::play, 1);
    person.act(What::cut_short);
    CHECK_FALSE(may_play(person.run, person.now_s));
    CHECK(may_play(person.run, person.now_s + gap_s));
}

TEST_CASE("study runner: training is over when each was felt whole") {
    Person person;
    person.act(What::go_on);
    person.act(What::go_on);
    for (std::size_t button = 0; button < kPatterns; ++button) {
        person.act(What::play, button);
        if (button == 2) person.act(What::cut_short);
        person.wait(kDurationS + 1.0);
    }
    CHECK_FALSE(may_go_on(person.run, person.now_s));
    person.feel(2);
    CHECK(may_go_on(person.run, person.now_s));
}

}  // namespace study_runner_test
