#include "model/set/parameter_paths.h"

#include "tests/support/golden.h"

namespace parameter_paths_test {

using namespace tact;

namespace {

Vibration vibration(double amplitude_g, double carrier_hz) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers = {{carrier_hz}};
    Vibration one;
    one.source = pattern;
    return one;
}

using Paths = std::vector<std::vector<std::size_t>>;

}  // namespace

TEST_CASE("parameter paths: patterns that differ in one number alone, in its order") {
    const std::vector<Vibration> set{vibration(1.0, 250.0), vibration(0.5, 100.0),
                                     vibration(1.0, 100.0), vibration(1.0, 40.0),
                                     vibration(0.7, 60.0)};
    CHECK(paths_along(set, PatternParameter::carrier) == Paths{{3, 2, 0}});
    CHECK(paths_along(set, PatternParameter::amplitude) == Paths{{1, 2}});
    CHECK(most_joining(set) == PatternParameter::carrier);
    CHECK_FALSE(most_joining(std::span(set).last(1)));
}

TEST_CASE("parameter paths: recordings are in none") {
    std::vector<Vibration> set{vibration(1.0, 250.0), vibration(1.0, 100.0)};
    set[0].source = Measurement{};
    CHECK(paths_along(set, PatternParameter::carrier).empty());
    CHECK_FALSE(most_joining(set));
    CHECK_FALSE(value_of(set[0], PatternParameter::carrier));
}

}  // namespace parameter_paths_test
