#include "model/text/names.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace natural_order_test {

using namespace tact;

TEST_CASE("natural order: people count, and so do names") {
    const std::vector<std::string> ordered{"",
                                           "1",
                                           "01",
                                           "2",
                                           "10",
                                           "a",
                                           "a1",
                                           "a1b2",
                                           "a1b10",
                                           "a2",
                                           "a10",
                                           "a10b",
                                           "b",
                                           "b99999999999999999999",
                                           "b100000000000000000000",
                                           "test_0",
                                           "test_2",
                                           "test_11",
                                           "\u00fc2",
                                           "\u00fc10",
                                           "\u9707 2",
                                           "\u9707 10"};
    std::vector<std::string> sorted = ordered;
    std::ranges::reverse(sorted);
    std::ranges::sort(sorted, naturally_before);
    // 01 and 1 are one number; their bytes decide.
    std::vector<std::string> expected = ordered;
    std::swap(expected[1], expected[2]);
    CHECK(sorted == expected);
}

TEST_CASE("natural order: it is a strict total order") {
    const std::vector<std::string> names{"a",   "a0",   "a00", "a01", "a1",
                                         "a1x", "a01x", "",    "10",  "9x"};
    for (const std::string& a : names) {
        CHECK_FALSE(naturally_before(a, a));
        for (const std::string& b : names) {
            if (a != b) CHECK(naturally_before(a, b) != naturally_before(b, a));
            for (const std::string& c : names) {
                if (naturally_before(a, b) && naturally_before(b, c)) CHECK(naturally_before(a, c));
            }
        }
    }
}

}  // namespace natural_order_test
