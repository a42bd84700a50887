#include "model/signal/waveform.h"

#include <doctest/doctest.h>

#include <vector>

namespace relative_difference_test {

using namespace tact;

using Signal = std::vector<double>;

TEST_CASE("relative difference: 0 for the same, 1 for what has nothing in common") {
    CHECK(relative_difference(Signal{1.0, 2.0}, Signal{1.0, 2.0}) == 0.0);
    CHECK(relative_difference(Signal{1.0, 0.0}, Signal{0.0, 3.0}) == 1.0);
    CHECK(relative_difference(Signal{1.0, -1.0}, Signal{-1.0, 1.0}) == 1.0);
    CHECK(relative_difference(Signal{3.0, 1.0}, Signal{1.0, 1.0}) == 2.0 / 6.0);
}

TEST_CASE("relative difference: silence equals silence and nothing else") {
    CHECK(relative_difference(Signal{}, Signal{}) == 0.0);
    CHECK(relative_difference(Signal{0.0, 0.0}, Signal{}) == 0.0);
    CHECK(relative_difference(Signal{0.0, 0.1}, Signal{}) == 1.0);
}

TEST_CASE("relative difference: it is symmetric, and the scale of both does not matter") {
    const Signal a{0.1, 0.7, 0.3};
    const Signal b{0.2, 0.1};
    CHECK(relative_difference(a, b) == relative_difference(b, a));
    CHECK(relative_difference(Signal{0.4, 2.8, 1.2}, Signal{0.8, 0.4}) ==
          relative_difference(a, b));
}

}  // namespace relative_difference_test
