#include "app/progress/progress.h"

#include <doctest/doctest.h>

namespace time_left_test {

using namespace tact;

TEST_CASE("time left: work goes on as fast as it went") {
    CHECK(time_left_text(30.0, 0.5) == "about 30 s left");
    CHECK(time_left_text(10.0, 0.25) == "about 30 s left");
    CHECK(time_left_text(60.0, 0.2) == "about 4 min left");
    CHECK(time_left_text(100.0, 0.01) == "about 3 h left");
}

TEST_CASE("time left: it is rounded up, to what is worth telling") {
    CHECK(time_left_text(10.0, 0.6) == "about 7 s left");
    CHECK(time_left_text(31.0, 0.5) == "about 35 s left");
    CHECK(time_left_text(61.0, 0.5) == "about 70 s left");
    CHECK(time_left_text(121.0, 0.5) == "about 3 min left");
}

TEST_CASE("time left: nothing is told too early, too late, or of what does not move") {
    CHECK(time_left_text(1.0, 0.3).empty());
    CHECK(time_left_text(100.0, 0.0).empty());
    CHECK(time_left_text(100.0, 0.99).empty());
    CHECK(time_left_text(100.0, 1.0).empty());
}

}  // namespace time_left_test
