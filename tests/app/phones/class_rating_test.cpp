// A class that rates together: what is on the disk is what the phones were asked and said.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "app/phones/phones.h"
#include "model/study/study_results.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace class_rating_test {

using namespace tact;
using nlohmann::json;

namespace {

PatternSet rated_set(std::size_t count = 4) {
    PatternSet set = short_patterns(count);
    set.study.repetitions = 1;
    return set;
}

std::vector<PhonePattern> made(const PatternSet& set) {
    std::vector<PhonePattern> patterns;
    for (const std::string& name : names_of(set)) patterns.push_back({name, {50, 50}, ""});
    return patterns;
}

ClassRating begun(const PatternSet& set, const std::filesystem::path& folder) {
    auto rating = class_rating(set, made(set), folder);
    REQUIRE(rating);
    return *std::move(rating);
}

std::string answer(std::size_t at, double similarity) {
    return json{{"k", at},
                {"similarity", similarity},
                {"plays", {1, 1}},
                {"first", "left"},
                {"response_ms", 1500}}
        .dump();
}

// Answers all that this phone is asked: identical ones are noticed.
void rate_all(ClassRating& rating, int phone, const std::string& nickname) {
    const json card = json::parse(card_of(rating, phone, nickname));
    for (std::size_t k = 0; k < card.at("trials").size(); ++k) {
        const json& trial = card.at("trials")[k];
        const double alike = trial[0] == trial[1] ? 95.0 : 20.0 + 5.0 * trial[0].get<double>();
        REQUIRE(take_rating(rating, phone, answer(k, alike)));
    }
}

}  // namespace

TEST_CASE("class rating: a study as any other comes out") {
    const TemporaryFolder folder;
    const PatternSet set = rated_set();
    ClassRating rating = begun(set, folder.path / "class");
    CHECK_FALSE(std::filesystem::exists(folder.path / "class"));  // nobody has answered
    for (int phone = 1; phone <= 3; ++phone) rate_all(rating, phone, "P" + std::to_string(phone));
    CHECK(progress_of(rating).finished == 3);
    const auto records = read_study_folder(folder.path / "class");
    REQUIRE(records);
    REQUIRE(records->size() == 3);
    CHECK(records->front().header.device.name == kPhoneDevice);
    CHECK(records->front().header.consented);
    const auto results = study_results(*records, rule_of(*records));
    REQUIRE(results);
    for (const ParticipantSummary& one : results->people) {
        CHECK(one.excluded == "");
        CHECK_FALSE(one.rehearsal);
        CHECK(one.answers == one.wanted);
    }
    CHECK(results->study.labels == names_of(set));
}

TEST_CASE("class rating: each phone has its own order, and each pair once") {
    const TemporaryFolder folder;
    ClassRating rating = begun(rated_set(5), folder.path / "class");
    std::set<json> orders;
    for (int phone = 1; phone <= 4; ++phone) {
        const json card = json::parse(card_of(rating, phone, "P" + std::to_string(phone)));
        orders.insert(card.at("trials"));
        std::set<std::pair<int, int>> pairs;
        int identical = 0;
        for (const json& trial : card.at("trials")) {
            const int a = trial[0].get<int>();
            const int b = trial[1].get<int>();
            identical += a == b ? 1 : 0;
            if (a != b) CHECK(pairs.insert(std::minmax(a, b)).second);
        }
        CHECK(pairs.size() == 10);
        CHECK(identical == kAttentionPairs);
        CHECK(card == json::parse(card_of(rating, phone, "P" + std::to_string(phone))));
    }
    CHECK(orders.size() == 4);
}

TEST_CASE("class rating: an answer counts once, in its turn, and of a known phone alone") {
    const TemporaryFolder folder;
    ClassRating rating = begun(rated_set(), folder.path / "class");
    CHECK_FALSE(take_rating(rating, 1, answer(0, 50.0)));  // it was asked nothing
    card_of(rating, 1, "Kim");
    CHECK_FALSE(take_rating(rating, 1, answer(1, 50.0)));
    CHECK(take_rating(rating, 1, answer(0, 50.0)));
    CHECK_FALSE(take_rating(rating, 1, answer(0, 60.0)));
    CHECK_FALSE(take_rating(rating, 1, "{}"));
    CHECK(json::parse(card_of(rating, 1, "Kim")).at("done") == 1);
    const auto records = read_study_folder(folder.path / "class");
    REQUIRE(records);
    REQUIRE(records->front().answers.size() == 1);
    CHECK(records->front().answers[0].similarity == 50.0);
}

TEST_CASE("class rating: nobody's file is another one's, whatever nicknames there are") {
    const TemporaryFolder folder;
    ClassRating rating = begun(rated_set(), folder.path / "class");
    const std::vector<std::string> nicknames{"Kim",    "Kim", "kim/..", "../../etc",
                                             "\u9f8d", "..",  "con",    ""};
    for (std::size_t k = 0; k < nicknames.size(); ++k) {
        const int phone = static_cast<int>(k) + 1;
        card_of(rating, phone, nicknames[k]);
        CHECK(take_rating(rating, phone, answer(0, 50.0)));
    }
    const auto records = read_study_folder(folder.path / "class");
    REQUIRE(records);
    CHECK(records->size() == nicknames.size());
    std::set<std::string> codes;
    for (const StudyRecord& one : *records) codes.insert(one.header.participant.code);
    CHECK(codes.size() == nicknames.size());
    std::size_t files = 0;
    for (const auto& one : std::filesystem::recursive_directory_iterator(folder.path)) {
        files += one.is_regular_file() ? 1 : 0;
    }
    CHECK(files == nicknames.size());
    ClassRating later = begun(rated_set(), folder.path / "class");  // another day, the same folder
    card_of(later, 1, "Kim");
    CHECK(take_rating(later, 1, answer(0, 80.0)));
    CHECK(read_study_folder(folder.path / "class")->size() == nicknames.size() + 1);
}

TEST_CASE("class rating: what cannot be kept is told, and is asked again") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path / "class");
    ClassRating rating = begun(rated_set(), folder.path / "class" / "file" / "below");
    std::ofstream(folder.path / "class" / "file") << "no folder";
    card_of(rating, 1, "Kim");
    CHECK_FALSE(take_rating(rating, 1, answer(0, 50.0)));
    CHECK(rating.fault != "");
    CHECK(json::parse(card_of(rating, 1, "Kim")).at("done") == 0);
    std::filesystem::remove(folder.path / "class" / "file");
    CHECK(take_rating(rating, 1, answer(0, 50.0)));
    CHECK(rating.fault == "");
}

TEST_CASE("class rating: too few and too many patterns are a sentence") {
    CHECK(class_rating_obstacle(rated_set(2)) != "");
    CHECK(class_rating_obstacle(rated_set(3)) == "");
    CHECK(class_rating_obstacle(rated_set(10)) == "");
    CHECK(class_rating_obstacle(rated_set(11)).find("11") != std::string::npos);
    PatternSet part = rated_set(11);
    part.study.patterns = {"p1", "p2", "p3"};
    CHECK(class_rating_obstacle(part) == "");
}

}  // namespace class_rating_test
