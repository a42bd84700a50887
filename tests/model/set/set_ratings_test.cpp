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
    set.vibrations.pop_back();
    CHECK(study_of(set).error().message ==
          "ratings \"P1\": expected names of patterns of the set, got \"a\"");
}

}  // namespace set_ratings_test
