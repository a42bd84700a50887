#include "devices/phone/on_off_times.h"

#include <doctest/doctest.h>

namespace on_off_times_test {

using namespace tact;
using Times = std::vector<int>;

TEST_CASE("on-off times: what is left at a moment begins with on, or with a 0") {
    const Times ms{30, 10, 20, 40};
    CHECK(on_off_from(ms, 0, false) == ms);
    CHECK(on_off_from(ms, 5, false) == Times{25, 10, 20, 40});
    CHECK(on_off_from(ms, 30, false) == Times{0, 10, 20, 40});
    CHECK(on_off_from(ms, 33, false) == Times{0, 7, 20, 40});
    CHECK(on_off_from(ms, 40, false) == Times{20, 40});
    CHECK(on_off_from(ms, 100, false).empty());
    CHECK(on_off_from(ms, 1'000'000'000'000, false).empty());
    CHECK(on_off_from({}, 5, true).empty());
}

TEST_CASE("on-off times: a loop from a moment is the same loop, turned") {
    CHECK(on_off_from(Times{30, 10, 20, 40}, 35, true) == Times{0, 5, 20, 40, 30, 5});
    CHECK(on_off_from(Times{30, 10, 20, 40}, 135, true) == Times{0, 5, 20, 40, 30, 5});
    CHECK(on_off_from(Times{30, 10, 20}, 45, true) == Times{45, 10, 5});  // its end is on
    CHECK(on_off_from(Times{50}, 20, true) == Times{50});
    CHECK(on_off_from(Times{0, 10, 20, 0}, 5, true) == Times{0, 5, 20, 5});
}

// A law: at every moment of two rounds both are on, or both off.
TEST_CASE("on-off times: a turned loop is on when the loop is") {
    const auto is_on = [](const Times& ms, std::int64_t at) {
        at %= length_ms(ms);
        for (std::size_t k = 0; k < ms.size(); ++k) {
            if (at < ms[k]) return k % 2 == 0;
            at -= ms[k];
        }
        return false;
    };
    for (const Times& ms : {Times{3, 1, 2, 4}, Times{0, 2, 3}, Times{1, 1, 1, 1, 5}}) {
        for (int from = 0; from < 2 * length_ms(ms); ++from) {
            const Times turned = on_off_from(ms, from, true);
            CHECK(length_ms(turned) == length_ms(ms));
            for (int at = 0; at < length_ms(ms); ++at) {
                CHECK(is_on(turned, at) == is_on(ms, from + at));
            }
        }
    }
}

TEST_CASE("on-off times: silence at the end makes a loop as long as its pattern") {
    CHECK(padded_on_off({30, 10, 20}, 100) == Times{30, 10, 20, 40});
    CHECK(padded_on_off({30, 10}, 100) == Times{30, 70});
    CHECK(padded_on_off({30, 10}, 20) == Times{30, 10});
    CHECK(padded_on_off({}, 100).empty());
    CHECK(padded_on_off({0, 10}, 100).empty());
}

}  // namespace on_off_times_test
