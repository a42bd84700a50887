#include "model/text/typed_number.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <string>

namespace typed_number_test {

using namespace tact;

namespace {

constexpr NumberRules kGrams{{0.0, 50.0}, "g"};
constexpr NumberRules kHertz{{0.1, 1000.0}, "Hz"};
constexpr NumberRules kMilliseconds{{0.0, 10'000.0}, "ms"};

double number(std::string_view text, double present, const NumberRules& rules) {
    const auto typed = typed_number(text, present, rules);
    REQUIRE_MESSAGE(typed, typed.error().message);
    CHECK(typed->remark.empty());
    return typed->value;
}

std::string refusal(std::string_view text, const NumberRules& rules) {
    const auto typed = typed_number(text, 1.0, rules);
    return typed ? "taken as " + std::to_string(typed->value) : typed.error().message;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("number entry: a number is itself, with a point or a comma, and its unit may follow") {
    for (const char* text :
         {"1.3", "1,3", "+1.3", " 1.3 ", "1.3 g", "1.3g", "1,3G", "13e-1", "1.3\t"}) {
        CAPTURE(std::string(text));
        CHECK(number(text, 7.0, kGrams) == 1.3);
    }
    CHECK(number("-3", 7.0, {{-6.0, 6.0}}) == -3.0);
    CHECK(number(".5", 7.0, kGrams) == 0.5);
    CHECK(number("-3 dB", 7.0, {{-6.0, 6.0}, "dB"}) == -3.0);
}

TEST_CASE("number entry: another unit of the same quantity is converted") {
    CHECK(number("0.2 s", 7.0, kMilliseconds) == 200.0);
    CHECK(number("250 ms", 7.0, {{0.0, 60.0}, "s"}) == 0.25);
    CHECK(number("0.15 kHz", 7.0, kHertz) == 150.0);
    CHECK(number("300 mg", 7.0, kGrams) == doctest::Approx(0.3).epsilon(1e-12));
    CHECK(number("0.1 mm", 7.0, {{0.0, 1e4}, "\u00b5m"}) == doctest::Approx(100.0).epsilon(1e-12));
    CHECK(number("9.80665 m/s2", 7.0, kGrams) == doctest::Approx(1.0).epsilon(1e-12));
}

TEST_CASE("number entry: changes are of the number that is there") {
    CHECK(number("*2", 1.5, kGrams) == 3.0);
    CHECK(number("* 0,5", 1.5, kGrams) == 0.75);
    CHECK(number("/4", 2.0, kGrams) == 0.5);
    CHECK(number("-10%", 200.0, kHertz) == doctest::Approx(180.0).epsilon(1e-12));
    CHECK(number("+10 %", 200.0, kHertz) == doctest::Approx(220.0).epsilon(1e-12));
    // 20 dB are ten times the strength, by definition.
    CHECK(number("+20dB", 1.5, kGrams) == doctest::Approx(15.0).epsilon(1e-12));
    CHECK(number("-6 dB", 1.0, kGrams) == doctest::Approx(std::pow(10.0, -0.3)).epsilon(1e-12));
}

TEST_CASE("number entry: a sign alone is the number's own, and only % and dB make it a change") {
    constexpr NumberRules kAny{{-100.0, 100.0}, "g"};
    CHECK(number("-10", 50.0, kAny) == -10.0);
    CHECK(number("+0.1", 50.0, kAny) == 0.1);
    CHECK(number("-10%", 50.0, kAny) == doctest::Approx(45.0).epsilon(1e-12));
    CHECK(number("-10", 50.0, {{-100.0, 100.0}, "%"}) == -10.0);
    CHECK(number("-10%", 50.0, {{-100.0, 100.0}, "%"}) == -10.0);
}

TEST_CASE("number entry: a change knows its factor, for the other numbers that it is meant for") {
    const auto factor = [](std::string_view text) {
        return typed_number(text, 2.0, kGrams)->factor;
    };
    CHECK(factor("*3") == 3.0);
    CHECK(factor("/4") == 0.25);
    CHECK(factor("-10%").value_or(0.0) == doctest::Approx(0.9).epsilon(1e-12));
    CHECK(factor("+20dB").value_or(0.0) == doctest::Approx(10.0).epsilon(1e-12));
    CHECK_FALSE(factor("6"));
    CHECK_FALSE(factor("6 g"));
    CHECK(factor("*1000") == 1000.0);  // clamped as it is: others may have room
}

TEST_CASE("number entry: what is no finite number is refused, and says what would be one") {
    for (const char* text :
         {"",         " ",      "nan",    "NaN",    "-nan",    "inf",  "-inf", "infinity",
          "1e999",    "-1e999", "1e-999", "*1e999", "*inf",    "*nan", "/0",   "+inf%",
          "+99999dB", "abc",    "1.2.3",  "1,2,3",  "1,234.5", "0x10", "1 2",  "--1",
          "+-1",      "++1",    "**2",    "*",      "+",       "*2 g", "1e",   "1 apples"}) {
        CAPTURE(std::string(text));
        const auto typed = typed_number(text, 1.0, kGrams);
        REQUIRE_FALSE(typed);
        CHECK(contains(typed.error().message, "no number"));
    }
    for (const char* text : {"1e-320", "-5e-324"}) {
        CAPTURE(std::string(text));
        const auto typed = typed_number(text, 1.0, kGrams);
        REQUIRE_FALSE(typed);
        CHECK(contains(typed.error().message, "too near zero"));
    }
}

TEST_CASE("number entry: a unit of something else is refused by name") {
    CHECK(contains(refusal("300 ms", kHertz), "in ms: this is a number of Hz"));
    CHECK(contains(refusal("3 Hz", {{0.0, 1.0}}), "in Hz: this is a number without a unit"));
    CHECK(contains(refusal("+3dB", kHertz), "changes a strength"));
    CHECK(contains(refusal("+3dB", kMilliseconds), "changes a strength"));
    CHECK(contains(refusal("3dB", kGrams), "+3dB or -3dB"));
    CHECK(contains(refusal("10%", kGrams), "+10% or -10%"));
}

TEST_CASE("number entry: out of range is clamped, and said") {
    const auto most = typed_number("99", 1.0, kGrams);
    REQUIRE(most);
    CHECK(most->value == 50.0);
    CHECK(most->remark == "99 g is too much: 50 g, the most, was taken");
    const auto least = typed_number("-0.5", 1.0, kGrams);
    REQUIRE(least);
    CHECK(least->value == 0.0);
    CHECK(contains(least->remark, "-0.5 g is too little: 0 g, the least"));
    CHECK(number("50", 1.0, kGrams) == 50.0);
    CHECK(number("0", 1.0, kGrams) == 0.0);
}

TEST_CASE("number entry: whole numbers stay whole") {
    constexpr NumberRules kSteps{{1.0, 32.0}, "", true};
    CHECK(number("*2", 8.0, kSteps) == 16.0);
    CHECK(contains(refusal("2.5", kSteps), "no whole number"));
    CHECK(contains(refusal("*1.5", kSteps), "no whole number"));
}

TEST_CASE("number entry: the unit is what the format writes behind the number") {
    CHECK(unit_in("%.3g g") == "g");
    CHECK(unit_in("%.5g Hz") == "Hz");
    CHECK(unit_in("%.0f %%") == "%");
    CHECK(unit_in("%.3f").empty());
    CHECK(leading_unit("V/g, of the sensor") == "V/g");
    CHECK(leading_unit("s until the motion begins") == "s");
    CHECK(leading_unit("how much stronger").empty());
    CHECK(shown_number("%.3g g", 1.23456) == "1.23 g");
}

}  // namespace typed_number_test
