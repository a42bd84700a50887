#include "model/text/numbers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

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

TEST_CASE("numbers: for people, with a true minus, a dash for what is not a number") {
    CHECK(significant(31.2345) == "31.2");
    CHECK(significant(0.030449) == "0.0304");
    CHECK(significant(1234.5) == "1234");
    CHECK(significant(0.0) == "0.00");
    CHECK(grouped(61.749) == "61.7");
    CHECK(grouped(999.6) == "1,000");
    CHECK(grouped(499500.0) == "499,500");
    CHECK(grouped(-1234567.0) == "\u22121,234,567");
    CHECK(with_decimals(0.8701, 3) == "0.870");
    CHECK(with_decimals(-0.111, 2) == "\u22120.11");
    CHECK(with_decimals(-0.001, 2) == "0.00");
    for (const double none :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const std::string& text : {significant(none), grouped(none), with_decimals(none, 2),
                                        percent(none), exact_percent(none), duration_text(none)}) {
            CHECK(text == "\u2013");
        }
    }
}

TEST_CASE("numbers: for a terminal and files, as printf writes them") {
    for (const double value : {0.0, -0.0, 0.5, 2.5, -1.005, 123456.789, 1e-7, 9.9999e22}) {
        for (int digits = 0; digits <= 9; ++digits) {
            char text[64];
            std::snprintf(text, sizeof text, "%.*f", digits, value);
            CHECK(fixed_digits(value, digits) == text);
            std::snprintf(text, sizeof text, "%.*g", digits, value);
            CHECK(significant_digits(value, digits) == text);
        }
    }
    CHECK(fixed_digits(std::numeric_limits<double>::quiet_NaN(), 3) == "-");
    CHECK(plain_digits(2414.4, 3) == "2414");
    CHECK(plain_digits(0.25, 3) == "0.25");
}

TEST_CASE("numbers: a measured share is never rounded to none or to all") {
    CHECK(percent(0.0) == "0 %");
    CHECK(percent(1.0) == "100 %");
    CHECK(percent(0.1 + 0.2 + 0.3 + 0.4) == "100 %");
    CHECK(percent(0.0043) == "0.43 %");
    CHECK(percent(0.04) == "4 %");
    CHECK(percent(0.0996) == "10 %");
    CHECK(percent(0.625) == "63 %");
    CHECK(percent(0.994) == "99 %");
    CHECK(percent(0.9966) == "99.7 %");
    CHECK(percent(0.99999) == "> 99.9 %");
    CHECK(percent(1e-9) == "< 0.001 %");
    CHECK(percent(-0.12) == "\u221212 %");
    CHECK(percent(-1e-9) == "> \u22120.001 %");
    CHECK(percent(-1e-15) == "0 %");
    CHECK(percent(5.25) == "525 %");
    for (double share = 1e-10; share < 1.0; share += 0.00037) {
        CHECK(percent(share) != "0 %");
        CHECK(percent(share) != "100 %");
    }
    CHECK(percent_range(0.481, 0.85) == "48 to 85 %");
    CHECK(exact_percent(0.125) == "12.5 %");
    CHECK(percent_done(0.9999) == "99 %");
    CHECK(percent_done(1.0) == "100 %");
}

TEST_CASE("numbers: durations, in the two units that tell them") {
    CHECK(duration_text(0.0) == "0 s");
    CHECK(duration_text(0.84) == "0.84 s");
    CHECK(duration_text(9.96) == "10 s");
    CHECK(duration_text(59.4) == "59 s");
    CHECK(duration_text(59.6) == "1 min 00 s");
    CHECK(duration_text(282.0) == "4 min 42 s");
    CHECK(duration_text(3720.0) == "1 h 02 min");
}

}  // namespace numbers_test
