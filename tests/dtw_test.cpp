#include "model/dtw.h"

#include "golden.h"

using namespace tact;
using golden::Json;

TEST_CASE("dtw: distances equal the independent program's") {
    const Json dtw_json = golden::read("dtw.json");
    const Json& cases = dtw_json.at("cases");
    REQUIRE(cases.size() > 20);
    for (const Json& c : cases) {
        const std::vector<double> x = c.at("x");
        const std::vector<double> y = c.at("y");
        const double expected = c.at("distance");
        // The path sums at most 80 terms; each may round once in another order.
        CHECK(std::abs(dtw(x, y) - expected) <= 1e-12 * std::max(1.0, expected));
        CHECK(std::abs(dtw(y, x) - expected) <= 1e-12 * std::max(1.0, expected));
    }
}

TEST_CASE("dtw: constants are apart by their difference on every step of the longer one") {
    CHECK(dtw(std::vector<double>(3, 2.0), std::vector<double>(4, 5.0)) == 12.0);
}

TEST_CASE("dtw: waiting is free") {
    const std::vector<double> once{0, 1, 2, 1, 0};
    const std::vector<double> slow{0, 0, 1, 1, 1, 2, 1, 0, 0, 0};
    CHECK(dtw(once, slow) == 0.0);
    CHECK(dtw(once, once) == 0.0);
}

TEST_CASE("dtw: nothing is as far from something as can be, and at nothing from nothing") {
    CHECK(dtw({}, {}) == 0.0);
    CHECK(std::isinf(dtw(std::vector<double>{1.0}, {})));
    CHECK(std::isinf(dtw({}, std::vector<double>{1.0})));
}

TEST_CASE("dtw: a stop ends a long comparison at once") {
    std::stop_source stop;
    stop.request_stop();
    const std::vector<double> large(100'000, 1.0);  // 1e10 cells: minutes, if not stopped
    CHECK(std::isinf(dtw(large, large, stop.get_token())));
}
