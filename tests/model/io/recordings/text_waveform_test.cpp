#include "model/io/recordings/text_waveform.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "model/text/numbers.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace text_waveform_test {

using namespace tact;

namespace {

std::vector<double> samples(std::string_view text) {
    const auto waveform = parse_text_waveform(text, "w.txt");
    REQUIRE_MESSAGE(waveform, (waveform ? "" : waveform.error().message));
    CHECK(waveform->rate_hz == kModelRateHz);
    return waveform->samples_g;
}

std::string fault(std::string_view text) {
    const auto waveform = parse_text_waveform(text, "w.txt");
    REQUIRE_FALSE(waveform);
    return waveform.error().message;
}

}  // namespace

TEST_CASE("text waveform: one number a line, as any program writes it") {
    const std::vector<double> expected{0.0, -1.5, 0.0025};
    CHECK(samples("0\n-1.5\n2.5e-3\n") == expected);
    CHECK(samples("0\n-1.5\n2.5e-3") == expected);
    CHECK(samples("0\r\n-1.5\r\n+2.5E-003\r\n") == expected);
    CHECK(samples("\xEF\xBB\xBF"
                  "0\n-1.5\n2.5e-3\n\n  \r\n\n") == expected);
    CHECK(samples("  0\n\t-1.5 \n2.5e-3\n") == expected);
}

TEST_CASE("text waveform: anything that is no number is refused with its line") {
    CHECK(fault("0\nabc\n") == "w.txt:2: expected one finite number, got \"abc\"");
    CHECK(fault("0\n1\nNaN\n") == "w.txt:3: expected one finite number, got \"NaN\"");
    CHECK(fault("inf\n") == "w.txt:1: expected one finite number, got \"inf\"");
    CHECK(contains(fault("-Infinity\n"), "w.txt:1: "));
    CHECK(contains(fault("1e999\n"), "w.txt:1: "));
    CHECK(contains(fault("1 2\n"), "w.txt:1: "));
    CHECK(contains(fault("0,5\n"), "\"0,5\""));
    CHECK(contains(fault("0\n\n1\n"), "w.txt:2: expected a number, got an empty line"));
    CHECK(contains(fault("2e6\n"), "1,000,000 g"));
    CHECK(fault("0\n" + std::string(100'000, 'x')).size() < 200);
}

TEST_CASE("text waveform: no sample is no waveform") {
    CHECK(fault("") == "w.txt:1: expected at least one sample, got an empty file");
    CHECK(fault("\r\n\n \n") == fault(""));
    CHECK(fault("\xEF\xBB\xBF") == fault(""));
}

TEST_CASE("text waveform: a minute is read; more is refused") {
    std::string minute;
    for (int n = 0; n < 600'000; ++n) minute += shortest_digits(std::sin(0.01 * n)) + "\n";
    CHECK(samples(minute).size() == 600'000);
    CHECK(contains(fault(minute + "0\n"), "w.txt:600001: expected at most 600,000 samples"));
}

TEST_CASE("text waveform: what is written is read back to the bit") {
    Waveform waveform{kModelRateHz, {}};
    for (int n = 0; n < 1000; ++n) waveform.samples_g.push_back(std::sin(n) / 3.0);
    const TemporaryFolder folder;
    const auto file = folder.path / "\u0436\u0443\u0436 1.txt";
    REQUIRE(write_text_waveform(file, waveform));
    CHECK(*read_text_waveform(file) == waveform);
    CHECK(print_text_waveform({kModelRateHz, {0.1, -2.0}}) == "0.1\n-2\n");
}

TEST_CASE("text waveform: another rate is written at 10 kHz") {
    const Waveform slow{5000.0, std::vector<double>(500, 0.25)};
    CHECK(samples(print_text_waveform(slow)).size() == 1000);
}

TEST_CASE("text waveform: a missing file is named") {
    const auto missing = read_text_waveform("no/such.txt");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message == "no/such.txt: there is no such file");
}

TEST_CASE(
    "text waveform: after an accident it is refused by a line, or printed and read the same") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string whole = "0.5\n-1e-3\r\n-0\n5e-324\n123456.789\n";
        const auto waveform = parse_text_waveform(after_mishaps(whole, random), "a.txt");
        if (!waveform) {
            CHECK(contains(waveform.error().message, "a.txt:"));
            continue;
        }
        ++accepted;
        const auto again = parse_text_waveform(print_text_waveform(*waveform), "again.txt");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        REQUIRE(again->samples_g.size() == waveform->samples_g.size());
        for (std::size_t n = 0; n < again->samples_g.size(); ++n) {
            CHECK(std::bit_cast<std::uint64_t>(again->samples_g[n]) ==
                  std::bit_cast<std::uint64_t>(waveform->samples_g[n]));  // -0 and denormals, too
        }
    }
    CHECK(accepted > 20);
}

}  // namespace text_waveform_test
