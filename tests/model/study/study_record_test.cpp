#include "model/study/study_record.h"

#include <doctest/doctest.h>

namespace study_record_test {

using namespace tact;

TEST_CASE("study record: a play counts when it was whole; what it was is kept either way") {
    PairAnswer answer;
    note_play(answer, true, {true, 0, 0.0});
    note_play(answer, true, {false, 0, 2.0});
    note_play(answer, true, {true, 3, 1.0});
    note_play(answer, false, {true, 0, 4.5});
    CHECK(answer.plays_left == 1);
    CHECK(answer.left == PlaysReport{2, 3, 2.0});
    CHECK(answer.plays_right == 1);
    CHECK(answer.right == PlaysReport{0, 0, 4.5});
}

TEST_CASE("study record: plays that were cut short are counted, of training and of answers") {
    StudyRecord record;
    CHECK(cut_short_plays(record) == 0);
    record.answers.resize(2);
    record.answers[0].broken_in_training = 2;
    note_play(record.answers[0], true, {false, 0, 0.0});
    note_play(record.answers[1], false, {true, 1, 0.0});
    note_play(record.answers[1], false, {true, 0, 0.0});
    CHECK(cut_short_plays(record) == 4);
    record.sortings.resize(1);
    record.sortings[0].plays = {0};
    note_play(record.sortings[0], 0, {false, 0, 0.0});
    CHECK(cut_short_plays(record) == 5);
}

TEST_CASE("study record: an answer counts if both sides were felt whole, on some device") {
    StudyRecord record;
    record.header.device.name = "pad";
    record.answers.resize(4);
    record.answers[0].plays_left = record.answers[0].plays_right = 1;
    record.answers[1].plays_left = 1;
    record.answers[1].right.broken = 2;
    record.answers[3].plays_left = record.answers[3].plays_right = 1;
    record.devices = {{3, {kNoDevice, "uncalibrated", {}}, ""}};
    CHECK(felt_of(record, 0) == Felt::whole);
    CHECK(felt_of(record, 1) == Felt::in_part);
    CHECK(felt_of(record, 2) == Felt::whole);  // of before: nothing is known of broken plays
    CHECK(felt_of(record, 3) == Felt::nothing);
    CHECK(device_of(record, 2).name == "pad");
    CHECK(device_of(record, 4).name == kNoDevice);
}

TEST_CASE("study record: whatever people are asked otherwise is named, and nothing else is") {
    StudyHeader first;
    first.patterns = {"a", "b", "c"};
    first.set_fingerprint = "f";
    const auto named = [&first](StudyKind kind, const auto& change) {
        first.kind = kind;
        StudyHeader now = first;
        change(now);
        return words_on_changes(changes_since(first, now));
    };
    // A field that is new to the design does not compile here: is anybody asked by it?
    const auto& [patterns, repetitions, attention_pairs, seed, order, gap_s, rest_s, break_every,
                 masking, headphones, attention, instructions, consent, groups] = first.design;
    CHECK((patterns.empty() && repetitions == 4 && attention_pairs == 3 && seed == 1 &&
           order == StudyOrder::full && gap_s == 1.0 && rest_s == 1.0 && break_every == 66 &&
           masking == 0.0 && headphones.empty() && attention == AttentionRule{} &&
           instructions.empty() && consent.empty() && groups.empty()));
    const auto pairs = [&](const auto& change) { return named(StudyKind::pairwise, change); };
    const auto sorts = [&](const auto& change) { return named(StudyKind::sorting, change); };
    CHECK(pairs([](StudyHeader&) {}).empty());
    CHECK(pairs([](StudyHeader& h) { h.design.repetitions = 2; }) == "repetitions 2, not 4");
    CHECK(pairs([](StudyHeader& h) { h.design.attention_pairs = 1; }) ==
          "identical pairs 1, not 3");
    CHECK(pairs([](StudyHeader& h) { h.design.order = StudyOrder::adaptive; }) ==
          "order adaptive, not full");
    CHECK(pairs([](StudyHeader& h) { h.design.gap_s = 0.5; }) == "gap 0.5 s, not 1 s");
    CHECK(pairs([](StudyHeader& h) { h.design.rest_s = 0; }) == "rest 0 s, not 1 s");
    CHECK(pairs([](StudyHeader& h) { h.design.break_every = 0; }) ==
          "a break every 0 trials, not 66 trials");
    CHECK(pairs([](StudyHeader& h) { h.design.masking = 0.3; }) == "masking noise 30 %, not 0 %");
    CHECK(pairs([](StudyHeader& h) { h.design.instructions = "x"; }) == "other instructions");
    CHECK(pairs([](StudyHeader& h) { h.design.consent = "x"; }) == "other words of consent");
    CHECK(pairs([](StudyHeader& h) {
              h.patterns = {"a", "d", "e", "f"};
          }) == "without the pattern \"b\" and 1 more; with the pattern \"d\" and 2 more");
    CHECK(pairs([](StudyHeader& h) {
              h.patterns = {"b", "a", "c"};
          }) == "the patterns in another order");
    CHECK(pairs([](StudyHeader& h) { h.set_fingerprint = "g"; }) ==
          "patterns that have been edited");
    CHECK(pairs([](StudyHeader& h) { h.set_fingerprint.clear(); }).empty());
    CHECK(sorts([](StudyHeader& h) {
              h.design.groups = {0, 3};
          }) == "rounds free 3, not by default");
    // Fields of the other kind of study, or nothing that a person notices.
    CHECK(pairs([](StudyHeader& h) { h.design.groups = {0, 3}; }).empty());
    CHECK(sorts([](StudyHeader& h) {
              h.design.repetitions = 2;
              h.design.attention_pairs = 1;
              h.design.order = StudyOrder::adaptive;
              h.design.break_every = 0;
              h.design.rest_s = 0;
          }).empty());
    CHECK(pairs([](StudyHeader& h) {
              h.design.seed = 7;
              h.design.headphones = "ears";
              h.design.attention.above = 50;
          }).empty());
    // The standard words written out are the standard words.
    CHECK(pairs([](StudyHeader& h) { h.design.consent = consent_of(StudyDesign{}); }).empty());
}

TEST_CASE("study record: people fix a design before simulations, and those before rehearsals") {
    const auto record = [](const char* code, const char* begun, const char* device,
                           bool synthetic) {
        StudyRecord one;
        one.header.participant.code = code;
        one.header.begun = begun;
        one.header.device.name = device;
        one.header.synthetic = synthetic;
        return one;
    };
    std::vector<StudyRecord> records{
        record("P4", "2026-01-05", "pad", false), record("P3", "2026-01-04", "pad", false),
        record("S1", "", "none: simulated", true), record("P1", "2026-01-01", kNoDevice, false)};
    CHECK(founder_of(records)->header.participant.code == "P3");
    records.erase(records.begin(), records.begin() + 2);
    CHECK(founder_of(records)->header.participant.code == "S1");
    records.erase(records.begin());
    CHECK(founder_of(records)->header.participant.code == "P1");
    CHECK(founder_of({}) == nullptr);
}

}  // namespace study_record_test
