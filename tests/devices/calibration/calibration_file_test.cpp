// What a calibration file holds is what is kept of it: over random tables, and after accidents.
#include "devices/calibration/calibration_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/coil.h"
#include "tests/support/misspelt_keys.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace calibration_file_test {

using namespace tact;

namespace {

double share_of(std::mt19937& random) {
    const std::size_t which = any_below(random, 6);
    if (which < 2) return static_cast<double>(which);
    return static_cast<double>(random()) / 4294967295.0;
}

std::string words(std::mt19937& random) {
    static const std::vector<std::string> kWords{
        "", "coil", "\u00e9 \"left\"", "a\\b\n", "alsa:hw 1,0", "\U0001f600", " "};
    return kWords[any_below(random, kWords.size())];
}

Calibration any_calibration(std::mt19937& random) {
    Calibration made;
    made.device = words(random);
    made.channel = 1 + static_cast<int>(any_below(random, 256));
    made.actuator = words(random);
    made.mounting = words(random);
    made.gain_note = words(random);
    made.sensor = words(random);
    made.date = words(random);
    made.load_mass_g = 1e5 * share_of(random);
    made.excursion_limit_mm = 100.0 * share_of(random);
    made.rms_limit = share_of(random);
    double f_hz = 1.0;
    for (std::size_t k = 0, count = 1 + any_below(random, 20); k < count; ++k) {
        made.points.push_back({f_hz, std::lerp(1e-6, 1e4, share_of(random)),
                               std::max(1e-9, share_of(random)), 1e3 * share_of(random),
                               share_of(random), any_below(random, 2) == 0});
        f_hz *= 1.01 + 0.4 * share_of(random);
    }
    return made;
}

}  // namespace

TEST_CASE("calibration file: whatever calibration there can be is written, and read as it was") {
    const TemporaryFolder folder;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const Calibration made = any_calibration(random);
        const auto again = parse_calibration(print_calibration(made), "c.json");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == made);
        if (seed > 5) continue;
        const auto file = folder.path / "c.json";
        REQUIRE(write_calibration(file, made));
        CHECK(*read_calibration(file) == made);
    }
}

TEST_CASE("calibration file: after an accident it is refused, or kept as it was read") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 800; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string text = print_calibration(any_calibration(random));
        const auto read = parse_calibration(after_mishaps(text, random), "c.json");
        if (!read) {
            CHECK(contains(read.error().message, "c.json"));
            CHECK_FALSE(contains(read.error().message, "\n"));
            continue;
        }
        ++accepted;
        const auto again = parse_calibration(print_calibration(*read), "again.json");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == *read);
    }
    CHECK(accepted > 20);
}

TEST_CASE("calibration file: it comes back as it went") {
    Calibration calibration = coil::table();
    calibration.device = "audio:ALSA:card";
    calibration.channel = 3;
    calibration.actuator = "coil \"A\"";
    calibration.rms_limit = 0.4;
    calibration.points[1].between = true;
    calibration.points[0].unknown = true;
    const auto back = parse_calibration(print_calibration(calibration), "c.json");
    REQUIRE(back);
    CHECK(*back == calibration);
}

TEST_CASE("calibration file: a limit that is misspelt is refused, not left out") {
    const std::string text = print_calibration(coil::table());
    check_misspelt_keys_refused(text, [](const std::string& changed) {
        const auto answer = parse_calibration(changed, "c.json");
        return answer ? std::string() : answer.error().message;
    });
    std::string other = text;
    other.insert(other.find('{') + 1, R"("colour": "red", )");
    CHECK(parse_calibration(other, "c.json").error().message ==
          "c.json: /: does not know \"colour\"");
}

TEST_CASE("calibration file: a bad one is refused by its place") {
    const auto fault = [](const char* text) {
        const auto answer = parse_calibration(text, "c.json");
        return answer ? std::string() : answer.error().message;
    };
    CHECK(fault("{}").find("expected a calibration") != std::string::npos);
    CHECK(fault(R"({"tactspace_calibration": 1})").find("/points") != std::string::npos);
    CHECK(fault(R"({"tactspace_calibration": 1, "points": []})").find("/points") !=
          std::string::npos);
    CHECK(fault(R"({"tactspace_calibration": 1, "points": [{"frequency_hz": 50}]})")
              .find("g_per_full_scale") != std::string::npos);
    CHECK(fault(R"({"tactspace_calibration": 1, "points": [
                    {"frequency_hz": 50, "g_per_full_scale": 1},
                    {"frequency_hz": 50, "g_per_full_scale": 1}]})")
              .find("/points/1/frequency_hz") != std::string::npos);
}

}  // namespace calibration_file_test
