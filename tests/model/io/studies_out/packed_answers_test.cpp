#include "model/io/studies_out/packed_answers.h"

#include "tests/support/golden.h"

namespace packed_answers_test {

using namespace tact;

namespace {

StudyHeader some_header() {
    StudyHeader header;
    header.patterns = {"low", "mid", "high"};
    header.set_fingerprint = "0123456789abcdef";
    header.device.name = "not told";
    return header;
}

constexpr const char* kHead =
    "participant,trial,a,b,side,rating,response_s,plays_left,plays_right,"
    "felt_first,at,device,fingerprint,synthetic\n";

std::string fault_of(const std::string& text) {
    const auto read = packed_answers(text, "f.csv", some_header());
    return read ? std::string() : read.error().message;
}

}  // namespace

TEST_CASE("packed answers: a record a participant, in the order of trials, sides as they were") {
    const auto read = packed_answers(
        std::string(kHead) +
            "P2,1,low,mid,b,30,4.5,2,1,b,2026-11-28T12:00:00Z,coil,0123456789abcdef,0\n"
            "P1,2,low,high,a,20,3,1,1,NA,,,,1\n"
            "P1,1,mid,mid,a,95,2,1,1,a,,,,0\n",
        "f.csv", some_header());
    REQUIRE(read);
    REQUIRE(read->size() == 2);
    const StudyRecord& second = (*read)[0];
    CHECK(second.header.participant.code == "P2");
    CHECK(second.header.device.name == "coil");
    CHECK_FALSE(second.header.synthetic);
    CHECK(second.answers[0].trial == Trial{1, 0});
    CHECK(second.answers[0].first == FeltFirst::left);
    CHECK(second.answers[0].plays_left == 2);
    CHECK(second.answers[0].response_s == 4.5);
    const StudyRecord& first = (*read)[1];
    CHECK(first.header.synthetic);  // one answer that nobody gave is enough
    REQUIRE(first.answers.size() == 2);
    CHECK(first.answers[0].trial.is_attention());
    CHECK(first.answers[1].trial == Trial{0, 2});
    CHECK(first.answers[1].first == FeltFirst::unknown);
    CHECK(first.header.device.name == "not told");
}

TEST_CASE("packed answers: what is wrong is told with its line, and what is missing is assumed") {
    CHECK(fault_of("participant,a,b,side,rating\nP1,low,mid,a,50\n").empty());
    CHECK(fault_of("participant,a,b,side,rating\n\"P 1\",low,mid,a,50").empty());
    CHECK(fault_of("").find("f.csv:1: expected a column participant") == 0);
    CHECK(fault_of("participant,a,b,rating\n").find("a column side") != std::string::npos);
    CHECK(fault_of("participant,a,b,side,rating\n").find("expected answers") != std::string::npos);
    for (const auto& [row, words] : {std::pair{"P1,low,other,a,50", "f.csv:2: expected the name"},
                                     {"P1,low,mid,left,50", "a or b as side"},
                                     {"P1,low,mid,a,101", "from 0 to 100 as rating"},
                                     {"P1,low,mid,a,", "as rating"},
                                     {"P1,low,mid,a,nan", "as rating"},
                                     {",low,mid,a,50", "expected a participant"},
                                     {"P1,low,mid,a,\"50", "f.csv:2"}}) {
        const std::string fault = fault_of(std::string("participant,a,b,side,rating\n") + row);
        CHECK_MESSAGE(fault.find(words) != std::string::npos, fault);
    }
}

TEST_CASE("packed answers: felt from another set, they say so") {
    const auto read = packed_answers(std::string(kHead) + "P1,1,low,mid,a,50,1,1,1,,,,ffff,0\n",
                                     "f.csv", some_header());
    REQUIRE(read);
    CHECK((*read)[0].header.set_fingerprint == "ffff");
}

}  // namespace packed_answers_test
