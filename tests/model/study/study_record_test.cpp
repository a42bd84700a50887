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

}  // namespace study_record_test
