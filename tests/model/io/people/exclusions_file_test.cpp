#include "model/io/people/exclusions_file.h"

#include <doctest/doctest.h>

#include "model/io/people/ratings_file.h"
#include "model/io/people/study_file.h"
#include "tests/support/temporary_folder.h"

namespace exclusions_file_test {

using namespace tact;

namespace {

StudyRecord rater(const std::string& code, double first) {
    StudyRecord record;
    record.header.patterns = {"a", "b", "c"};
    record.header.participant.code = code;
    record.header.device = {"a pad", "uncalibrated", {}};
    record.header.design.repetitions = 1;
    record.header.design.attention_pairs = 0;
    record.answers = {{{0, 1}, first, 1, 1, 5.0, ""},
                      {{0, 2}, 40.0, 1, 1, 5.0, ""},
                      {{1, 2}, 20.0, 1, 1, 5.0, ""}};
    return record;
}

struct People {
    TemporaryFolder folder;
    std::filesystem::path file = folder.path / kExclusionsFile;

    People() {
        for (const auto& [code, first] : {std::pair{"P1", 80.0}, {"P2", 70.0}, {"P3", 10.0}}) {
            REQUIRE(write_study_file(folder.path / study_file_name(code), rater(code, first)));
        }
    }
    std::vector<std::string> said(const CountRule& rule) const {
        const auto said = record_exclusions(folder.path, rule, "2026-11-23T10:00:00Z");
        REQUIRE_MESSAGE(said, (said ? "" : said.error().message));
        return *said;
    }
    LoadedRatings ratings(const CountRule& rule = {}) const {
        const std::vector<std::filesystem::path> paths{folder.path};
        auto read = read_ratings(paths, RatingScale::guess, rule);
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        return *std::move(read);
    }
};

std::string fault_of(const std::string& text) {
    const auto read = parse_exclusions(text, "exclusions.json");
    REQUIRE_FALSE(read);
    return read.error().message;
}

}  // namespace

TEST_CASE("exclusions: who is recorded with a reason is left out by whoever reads the folder") {
    const People people;
    CHECK(people.said({{}, {"P3"}, "asleep"}).size() == 1);
    const auto records = read_study_folder(people.folder.path);
    REQUIRE(records);
    CHECK((*records)[0].excluded.empty());
    CHECK((*records)[2].excluded == "asleep");
    const LoadedRatings ratings = people.ratings();
    CHECK(ratings.study.judgements.size() == 2);
    REQUIRE(ratings.left_out.size() == 1);
    CHECK(ratings.left_out[0].why == "excluded by name: asleep");
    // The folder of a single file is asked, too.
    const std::vector<std::filesystem::path> one{people.folder.path / "P1.jsonl",
                                                 people.folder.path / "P3.jsonl"};
    const auto two = read_ratings(one, RatingScale::guess);
    REQUIRE(two);
    CHECK(two->study.judgements.size() == 1);
    // The participant's own file is as it was.
    CHECK(read_study_file(one[1])->excluded.empty());
}

TEST_CASE("exclusions: to include by name takes the record back") {
    const People people;
    people.said({{}, {"P3", "P2"}, "asleep"});
    CHECK(people.ratings({{"P3"}, {}}).study.judgements.size() == 2);
    CHECK(people.said({{"P3"}, {}}).size() == 1);
    CHECK(people.ratings().study.judgements.size() == 2);
    CHECK(people.said({{"P3"}, {}}).empty());  // again: nothing to take back
    const auto left = read_exclusions(people.folder.path);
    REQUIRE(left);
    CHECK(*left == std::vector<Exclusion>{{"P2", "asleep", "2026-11-23T10:00:00Z"}});
}

TEST_CASE("exclusions: without a reason, or with the same again, nothing is written") {
    const People people;
    CHECK(people.said({{}, {"P3"}}).empty());
    CHECK_FALSE(std::filesystem::exists(people.file));
    people.said({{}, {"P3"}, "asleep"});
    CHECK(people.said({{}, {"P3"}, "asleep"}).empty());
    CHECK(people.said({{}, {"P3"}, "left early"}).size() == 1);
    CHECK(read_exclusions(people.folder.path)->front().because == "left early");
}

TEST_CASE("exclusions: a name that nobody has is refused, when recorded and when read") {
    const People people;
    const auto said = record_exclusions(people.folder.path, {{}, {"P9"}, "asleep"}, "now");
    REQUIRE_FALSE(said);
    CHECK(said.error().message.ends_with("expected the name of a participant, got \"P9\""));
    CHECK_FALSE(std::filesystem::exists(people.file));
    // A slip of the pen must not let the person in who is meant.
    people.folder.write(kExclusionsFile, print_exclusions({{"P33", "asleep", ""}}));
    const auto records = read_study_folder(people.folder.path);
    REQUIRE_FALSE(records);
    CHECK(records.error().message.ends_with("expected participants of the folder, got \"P33\""));
}

TEST_CASE("exclusions: a file that is not as it should be is refused with the place") {
    CHECK(fault_of("{}").starts_with("exclusions.json: /tactspace_exclusions: expected 1"));
    const std::string head = R"({"tactspace_exclusions": 1, "excluded": )";
    CHECK(fault_of(head + R"([{"participant": "P1"}]})")
              .starts_with("exclusions.json: /excluded/0/because: expected a text"));
    CHECK(fault_of(head + R"([{"participant": "", "because": "x"}]})")
              .starts_with("exclusions.json: /excluded/0/participant: expected a text"));
    CHECK(fault_of(head + R"([{"participant": "P1", "becuase": "x", "because": "y"}]})")
              .starts_with("exclusions.json: /excluded/0: does not know \"becuase\"; the nearest "
                           "key is \"because\""));
    CHECK(
        fault_of(R"({"tactspace_exclusions": 1, "exclude": []})")
            .starts_with(
                "exclusions.json: /: does not know \"exclude\"; the nearest key is \"excluded\""));
    CHECK(fault_of(head + R"([{"participant": "P1", "because": "x"},
                              {"participant": "P1", "because": "y"}]})")
              .starts_with("exclusions.json: /excluded: expected each participant once"));
    CHECK(fault_of("[]").starts_with("exclusions.json: /: expected an object"));
    const std::vector<Exclusion> all{{"P \"1\"", "so\nsaid", "t"}, {"P2", "x", ""}};
    CHECK(*parse_exclusions(print_exclusions(all), "e") == all);
}

}  // namespace exclusions_file_test
