#include "model/set/set_ratings.h"

#include <doctest/doctest.h>

#include <cmath>

namespace set_ratings_test {

using namespace tact;

namespace {

PatternSet three() {
    PatternSet set;
    for (const char* name : {"a", "b", "c"}) {
        Vibration vibration;
        vibration.name = name;
        vibration.source = Pattern{};
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace

TEST_CASE("ratings of a set: a study comes back as it was kept, unrated pairs too") {
    const RatingStudy study{
        {"a", "b", "c"}, true, {{"P1", {1.0, 2.0, std::nan("")}}, {"P1", {3.0, 4.0, 5.0}}}};
    PatternSet set = three();
    set.ratings = kept_ratings(study, "people.csv");
    CHECK(set == set);  // no NaN among its values
    CHECK(set.ratings[1].file == "people.csv");
    const Expected<RatingStudy> back = study_of(set);
    REQUIRE(back);
    CHECK(back->judgements[1] == study.judgements[1]);
    CHECK(std::isnan(back->judgements[0].condensed[2]));
    CHECK(back->judgements[0].condensed[0] == 1.0);
    CHECK(mean_ratings(*back).condensed == std::vector<double>{2.0, 3.0, 5.0});
}

TEST_CASE(
    "ratings of a set: they follow the order of its patterns, and know when they do not fit") {
    PatternSet set = three();
    CHECK_FALSE(study_of(set));
    set.ratings = kept_ratings({{"a", "b", "c"}, true, {{"P1", {1.0, 2.0, 3.0}}}}, "");
    std::swap(set.vibrations[0], set.vibrations[2]);  // c b a
    CHECK(study_of(set)->judgements[0].condensed == std::vector<double>{3.0, 2.0, 1.0});
    Vibration unrated = set.vibrations[0];
    unrated.name = "d";
    set.vibrations.push_back(unrated);
    REQUIRE(study_of(set));
    CHECK(unrated_patterns(*study_of(set)) == std::vector<std::string>{"d"});
    set.vibrations.pop_back();
    set.vibrations.pop_back();
    CHECK(study_of(set).error().message ==
          "ratings \"P1\": expected names of patterns of the set, got \"a\"");
}

TEST_CASE("ratings of a set: those of nobody stay marked, whatever file they came from") {
    const RatingStudy study{
        {"a", "b", "c"}, true, {{"S1", {1.0, 2.0, 3.0}}, {"P1", {1.0, 2.0, 3.0}}}, {{"S1", true}}};
    PatternSet set = three();
    set.ratings = kept_ratings(study, "R.csv");
    CHECK(set.ratings[0].mark.synthetic);
    CHECK_FALSE(set.ratings[1].mark.synthetic);
    CHECK(study_of(set)->standings == study.standings);
}

TEST_CASE("ratings of a set: as many as a study can have are kept, and say the same") {
    RatingStudy study{{"a", "b", "c"}, true, {}};
    for (int k = 0; k < 1004; ++k) {
        study.judgements.push_back(
            {"P" + std::to_string(k / 4), {k % 7 * 1.0, k % 11 * 1.0, k % 5 * 1.0}});
    }
    PatternSet set = three();
    set.ratings = kept_ratings(study, "R.csv");
    CHECK(set.ratings.size() == 251);
    CHECK(mean_ratings(*study_of(set)) == mean_ratings(study));
    study.judgements.resize(kMostKeptRatings);
    CHECK(kept_ratings(study, "R.csv").size() == kMostKeptRatings);
}

}  // namespace set_ratings_test
