#include "model/system/leading_number.h"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>

#include "model/common/random.h"

namespace leading_number_test {

using namespace tact;

namespace {

using Reader = std::optional<LeadingNumber> (*)(std::string_view);
constexpr std::array<Reader, 2> kReaders{leading_number, leading_number_by_c};

// Bits, as 0 and -0 are equal numbers.
bool is_same(const std::optional<LeadingNumber>& a, const std::optional<LeadingNumber>& b) {
    if (!a || !b) return !a && !b;
    return std::bit_cast<std::uint64_t>(a->value) == std::bit_cast<std::uint64_t>(b->value) &&
           a->length == b->length;
}

}  // namespace

TEST_CASE("leading number: a number ends where its text does, and other text has no value") {
    struct Row {
        const char* text;
        double value;
        std::size_t length;  // 0: no number
    };
    constexpr Row kRows[] = {{"1.5", 1.5, 3},
                             {"-1.5e3 g", -1500.0, 6},
                             {".5", 0.5, 2},
                             {"5.", 5.0, 2},
                             {"-0", -0.0, 2},
                             {"1e", 1.0, 1},
                             {"1e+", 1.0, 1},
                             {"2E-1x", 0.2, 4},
                             {"0x10", 0.0, 1},
                             {"1,5", 1.0, 1},
                             {"1.2.3", 1.2, 3},
                             {"1_000", 1.0, 1},
                             {"0e999999999", 0.0, 11},
                             {"5e-324", 5e-324, 6},
                             {"", 0, 0},
                             {"-", 0, 0},
                             {".", 0, 0},
                             {"-.e1", 0, 0},
                             {"+1", 0, 0},
                             {" 1", 0, 0},
                             {"inf", 0, 0},
                             {"-nan", 0, 0},
                             {"e5", 0, 0},
                             {"1e400", 0, 0},
                             {"-1e400", 0, 0},
                             {"1e-400", 0, 0},
                             {"\xC2\xBD", 0, 0}};
    for (const Row& row : kRows) {
        CAPTURE(row.text);
        for (const Reader read : kReaders) {
            const std::optional<LeadingNumber> expected =
                row.length == 0 ? std::nullopt
                                : std::optional(LeadingNumber{row.value, row.length});
            CHECK(is_same(read(row.text), expected));
        }
    }
}

TEST_CASE("leading number: every double that is written out reads back by both, to the last bit") {
    for (std::uint64_t k = 0; k < 20'000; ++k) {
        const auto value = std::bit_cast<double>(random_bits(2026, k));
        std::array<char, 40> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        const std::string text(digits.data(), end);
        CAPTURE(text);
        for (const Reader read : kReaders) {
            const auto number = read(text);
            if (!std::isfinite(value)) {
                CHECK_FALSE(number);
            } else {
                CHECK(is_same(number, LeadingNumber{value, text.size()}));
            }
        }
    }
}

}  // namespace leading_number_test
