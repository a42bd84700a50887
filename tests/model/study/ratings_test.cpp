#include "model/study/ratings.h"

#include <cmath>
#include <limits>

#include "tests/support/golden.h"
#include "tests/support/temporary_folder.h"

#include "model/dissimilarity/correlation.h"

namespace ratings_test {

using namespace tact;
using golden::Json;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

RatingStudy study_of(const Json& json) {
    RatingStudy study;
    for (std::size_t k = 0; k < json.at("size"); ++k) study.labels.push_back(std::to_string(k));
    for (const Json& matrix : json.at("matrices")) {
        Judgement judgement{std::to_string(study.judgements.size()), {}};
        for (const Json& value : matrix) {
            judgement.condensed.push_back(value.is_null() ? kUnknown : value.get<double>());
        }
        study.judgements.push_back(judgement);
    }
    return study;
}

// Three patterns, two people; one went through them twice.
RatingStudy small_study() {
    return {{"a", "b", "c"},
            true,
            {{"P1", {10, 20, kUnknown}}, {"P1", {30, kUnknown, kUnknown}}, {"P2", {60, 80, 90}}}};
}

}  // namespace

TEST_CASE("ratings: reliability is that of another program, over all halves") {
    const Json table = golden::read("evaluation.json");
    for (const Json& json : table.at("reliability")) {
        CAPTURE(json.at("name").get<std::string>());
        const RatingStudy study = study_of(json);
        const Reliability found = reliability(study);
        CHECK(found.voices == study.judgements.size());
        CHECK_FALSE(found.is_of_one_person);
        CHECK(std::abs(found.half_rho - json.at("half_rho").get<double>()) <= 1e-13);
        CHECK(std::abs(found.spearman_brown - json.at("spearman_brown").get<double>()) <= 1e-13);
        CHECK(std::abs(found.one_with_others - json.at("one_with_others").get<double>()) <= 1e-13);
    }
}

TEST_CASE("ratings: people who agree are reliable, one alone is of unknown reliability") {
    RatingStudy study{{"a", "b", "c", "d"}, true, {}};
    study.judgements.push_back({"P1", {1, 2, 3, 4, 5, 6}});
    CHECK(reliability(study).voices == 1);
    CHECK(std::isnan(reliability(study).spearman_brown));
    study.judgements.push_back({"P1", {10, 20, 30, 40, 50, 60}});
    CHECK(reliability(study).is_of_one_person);
    CHECK(reliability(study).voices == 2);
    CHECK(reliability(study).spearman_brown == 1.0);
    for (int k = 0; k < 15; ++k) {  // more than can be parted in every way
        study.judgements.push_back({"Q" + std::to_string(k), {1, 2, 3, 4, 5, 6}});
    }
    CHECK(reliability(study).voices == 16);
    CHECK(reliability(study).spearman_brown == 1.0);
    CHECK(reliability(study).one_with_others == 1.0);
    CHECK(std::isnan(reliability({{"a", "b"}, true, {}}).half_rho));
}

TEST_CASE("ratings: many voices of drawn halves are about as reliable as of all") {
    RatingStudy study{{}, true, {}};
    for (int k = 0; k < 9; ++k) study.labels.push_back(std::to_string(k));
    const std::vector<double> truth = golden::noise(1, 36, 1.0).samples_g;
    for (std::uint32_t k = 0; k < 16; ++k) {
        Judgement judgement{std::to_string(k), golden::noise(k + 2, 36, 1.0).samples_g};
        for (std::size_t p = 0; p < 36; ++p) judgement.condensed[p] += truth[p] + 3.0;
        study.judgements.push_back(judgement);
    }
    // Signal and noise of one size: the mean of eight has reliability 8/9, that of 16 has 16/17.
    CHECK(std::abs(reliability(study).spearman_brown - 16.0 / 17.0) <= 0.06);
}

TEST_CASE("ratings: the mean is of people, not of passes, and of those who rated the pair") {
    const Dissimilarity mean = mean_ratings(small_study());
    CHECK(mean == Dissimilarity{3, {40, 50, 90}});
    RatingStudy holed = small_study();
    holed.judgements[2].condensed[2] = kUnknown;
    CHECK(std::isnan(mean_ratings(holed).condensed[2]));
    CHECK(mean_ratings({{"a", "b"}, true, {}}).condensed.size() == 1);
}

TEST_CASE("ratings: matched by name, whatever the order") {
    const auto study = matched(small_study(), {"c", "a", "b"});
    REQUIRE(study);
    CHECK(study->labels == std::vector<std::string>{"c", "a", "b"});
    CHECK(study->judgements[2].condensed == std::vector<double>{80, 90, 60});
    CHECK(*matched(*matched(*study, {"b", "c", "a"}), {"c", "a", "b"})->judgements.rbegin() ==
          study->judgements[2]);
}

TEST_CASE("ratings: spread over their own names they stay, and turned around twice, too") {
    RatingStudy study = small_study();
    for (Judgement& judgement : study.judgements) {
        for (double& value : judgement.condensed) {
            if (std::isnan(value)) value = 0.0;  // so that two studies can be compared
        }
    }
    study.standings = {{.participant = "P2", .synthetic = true}};
    study.fingerprint = "f";
    study.versions = {"v1", "v2", "v3"};
    study.edited = {"b"};
    study.gone = {"d"};
    study.left_out = 2;
    study.rehearsals = 1;
    CHECK(*spread_over(study, {"a", "b", "c"}) == study);
    const RatingStudy turned = *spread_over(study, {"c", "b", "a"});
    CHECK(turned.versions == std::vector<std::string>{"v3", "v2", "v1"});
    CHECK(*spread_over(turned, {"a", "b", "c"}) == study);
}

TEST_CASE("ratings: those of some of the patterns serve, and the others are named") {
    const auto study = matched(small_study(), {"d", "a", "b", "c", "e"});
    REQUIRE(study);
    CHECK(unrated_patterns(*study) == std::vector<std::string>{"d", "e"});
    CHECK(remark_on_unrated({"d", "e"}, 5) ==
          "2 of 5 patterns were not rated and are left out: \"d\", \"e\"");
    // After a rehearsal none is left that they could be left out of.
    CHECK(remark_on_unrated({"a", "b"}, 2) == "No pattern was rated by anyone who counts");
    CHECK(remark_on_unrated({}, 0).empty());
    const Dissimilarity all = mean_ratings(*study);
    const Dissimilarity own = mean_ratings(small_study());
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) CHECK(all(i + 1, j + 1) == own(i, j));
        CHECK(std::isnan(all(0, i + 1)));
    }
    RatingStudy two{{"a", "b"}, true, {{"P", {1.0}}}};
    CHECK(matched(two, {"a", "b", "c"}).error().message ==
          "expected ratings of at least three patterns of the set, got those of 2");
}

TEST_CASE("ratings: how one agrees with the others is the rho with their mean without them") {
    const RatingStudy study{
        {"a", "b", "c"}, true, {{"P1", {1, 2, 3}}, {"P2", {10, 20, 30}}, {"P3", {30, 20, 5}}}};
    const auto agreement = agreement_with_others(study);
    REQUIRE(agreement.size() == 3);
    CHECK(agreement[0].participant == "P1");
    CHECK(agreement[0].rho ==
          spearman(std::vector<double>{1, 2, 3}, std::vector<double>{20, 20, 17.5}));
    CHECK(agreement[2].rho == -1.0);
    const Reliability all = reliability(study);
    CHECK((agreement[0].rho + agreement[1].rho + agreement[2].rho) / 3.0 ==
          doctest::Approx(all.one_with_others).epsilon(1e-12));
    CHECK(agreement_with_others({{"a", "b", "c"}, true, {{"P1", {1, 2, 3}}}}).empty());
}

TEST_CASE("ratings: what does not fit the set is named") {
    const auto fault = [](const RatingStudy& study, const std::vector<std::string>& names) {
        const auto answer = matched(study, names);
        REQUIRE_FALSE(answer);
        return answer.error().message;
    };
    CHECK(fault(small_study(), {"a", "c"}) == "expected names of patterns of the set, got \"b\"");
    RatingStudy bare = small_study();
    bare.is_named = false;
    CHECK(matched(bare, {"x", "y", "z"})->labels[2] == "z");
    CHECK(fault(bare, {"x", "y"}) ==
          "expected ratings of 2 patterns, as many as the set has, got 3");
}

TEST_CASE("ratings: of names that the set has not, the first is said, and how many others") {
    const auto answer = [](const std::vector<std::string>& labels) {
        const std::vector<double> condensed(pair_count(labels.size()), 1.0);
        return spread_over({labels, true, {{"P1", condensed}}}, {"a", "b", "c"}).error().message;
    };
    CHECK(answer({"a", "b", "x"}).ends_with("got \"x\""));
    CHECK(answer({"a", "y", "x"}).ends_with("got \"y\" and 1 more"));
}

}  // namespace ratings_test
