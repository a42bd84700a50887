#include "model/set/set_ratings.h"

#include <doctest/doctest.h>

namespace set_study_test {

using namespace tact;

namespace {

PatternSet three() {
    PatternSet set;
    for (const char* name : {"a", "b", "c"}) {
        Pattern pattern;
        pattern.carriers[0].frequency_hz = 60.0 + 40.0 * static_cast<double>(set.vibrations.size());
        Vibration vibration;
        vibration.name = name;
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace

TEST_CASE(
    "study fingerprint: the same for what feels the same, another for any change that is felt") {
    const PatternSet set = three();
    const std::string print = study_fingerprint(set, {"a", "b"});
    CHECK(print.size() == 16);
    PatternSet other = set;
    other.vibrations[2].name = "d";  // takes no part
    other.vibrations[0].colour = "#123456";
    CHECK(study_fingerprint(other, {"a", "b"}) == print);
    other = set;
    std::get<Pattern>(other.vibrations[1].source).amplitude_g *= 1.001;
    CHECK(study_fingerprint(other, {"a", "b"}) != print);
    CHECK(study_fingerprint(set, {"b", "a"}) != print);
    CHECK(study_fingerprint(set, {"a"}) != print);
}

}  // namespace set_study_test
