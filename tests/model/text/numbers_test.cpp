#include "model/text/numbers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace numbers_test {

using namespace tact;

TEST_CASE("numbers: any double survives its shortest digits") {
    for (const double value : {0.0, -0.0, 0.1, 1.0 / 3.0, -1e-300, 5e-324, 1.7976931348623157e308,
                               123456789.123456789, 70.0}) {
        const auto back = finite_number_in(shortest_digits(value));
        REQUIRE(back);
        CHECK(*back == value);
        CHECK(std::signbit(*back) == std::signbit(value));
    }
    CHECK(shortest_digits(0.1) == "0.1");
}

TEST_CASE("numbers: blanks and a plus sign are allowed, anything else is not a number") {
    CHECK(finite_number_in(" +1.5e3\t\r") == 1500.0);
    for (const char* text : {"", " ", "+", "+-1", "--1", "1,5", "1 2", "abc", "nan", "NaN", "inf",
                             "-Infinity", "1e400", "0x10", "1.5g"}) {
        CAPTURE(text);
        CHECK_FALSE(finite_number_in(text));
    }
}

TEST_CASE("numbers: steps of a slider are the decimals that a person would write") {
    CHECK(shortest_digits(33 * 0.05) == "1.6500000000000001");
    for (const double shares : {10.0, 20.0, 50.0, 100.0, 1000.0}) {
        for (int count = -2000; count <= 2000; ++count) {
            const std::string written = shortest_digits(multiple_of(1.0 / shares, count));
            CAPTURE(written);
            CHECK(written.size() <= 6);
            CHECK(finite_number_in(written) == count / shares);
        }
    }
    CHECK(multiple_of(5.0, 7.0) == 35.0);
    CHECK(multiple_of(0.3, 2.0) == 0.6);
    CHECK(multiple_of(0.05, 0.0) == 0.0);
}

TEST_CASE("numbers: thousands are grouped") {
    CHECK(grouped_digits(0) == "0");
    CHECK(grouped_digits(999) == "999");
    CHECK(grouped_digits(11'025) == "11,025");
    CHECK(grouped_digits(1'073'741'824) == "1,073,741,824");
}

}  // namespace numbers_test
