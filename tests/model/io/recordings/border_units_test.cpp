// Units that a column names, however it names them, and numbers that no unit would make plausible.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "model/io/recordings/acceleration_file.h"
#include "tests/support/temporary_folder.h"

namespace border_units_test {

using namespace tact;

namespace {

// A second of 50 Hz at 1 kHz.
std::string rows(double offset, double swing) {
    std::string text;
    for (int n = 0; n < 1000; ++n) {
        const double x = offset + swing * std::sin(0.1 * 3.14159265358979 * n);
        text += std::to_string(0.001 * n) + "," + std::to_string(x) + "\n";
    }
    return text;
}

// Its remarks, or what is wrong.
std::string said_of(const std::string& names, double offset, double swing,
                    const AccelerationOptions& options = {}) {
    const TemporaryFolder folder;
    const auto recording =
        read_acceleration_file(folder.write("a.csv", names + "\n" + rows(offset, swing)), options);
    if (!recording) return recording.error().message;
    std::string all;
    for (const std::string& remark : recording->remarks) all += remark + "; ";
    return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("units: a unit that a name ends with is the unit, in any spelling") {
    for (const char* name : {"x (m/s2)", "x [m/s^2]", "x in m/s2", "Beschleunigung in m/s\u00b2",
                             "acc m/s2", "acc / m/s2", "x_mps2", "m/s2"}) {
        CAPTURE(name);
        const std::string said = said_of(std::string("t,") + name, 9.8, 1.0);
        CHECK_FALSE(has(said, "expected"));
        CHECK_FALSE(has(said, "taken as g"));
    }
    for (const char* name : {"x (g)", "x g", "acc/g", "a_g"}) {
        CAPTURE(name);
        CHECK_FALSE(has(said_of(std::string("t/s,") + name, 1.0, 1.0), "taken as g"));
    }
}

TEST_CASE("units: one that is none of ours is refused by its name, never taken as g") {
    constexpr std::array kForeign{std::array{"a_mg", "\"mg\""},
                                  std::array{"x (mg)", "\"mg\""},
                                  std::array{"mV", "\"mv\""},
                                  std::array{"acc (mm/s2)", "\"mm/s2\""},
                                  std::array{"mm/s2", "\"mm/s2\""},
                                  std::array{"acc mm/s2", "\"mm/s2\""},
                                  std::array{"x [gal]", "\"gal\""},
                                  std::array{"x in furlongs", "\"furlongs\""},
                                  std::array{"acc / ft/s2", "\"ft/s2\""}};
    for (const auto& [name, unit] : kForeign) {
        CAPTURE(name);
        const std::string said = said_of(std::string("t,") + name, 0.0, 1.0);
        CHECK(has(said, std::string("expected a unit of g, m/s2 or V, got ") + unit));
    }
    for (const char* name : {"V", "voltage", "x (V)", "x_v"}) {
        CAPTURE(name);
        CHECK(has(said_of(std::string("t,") + name, 0.0, 1.0), "sensitivity in V/g"));
    }
    CHECK(has(said_of("t (min),x (g)", 0.0, 1.0), "expected a time in s, ms, us or ns"));
}

TEST_CASE("units: numbers that are no vibration in g are not taken as g in silence") {
    CHECK(has(said_of("t,x", 9.81, 1.0), "a mean of 9.81 is gravity in m/s2"));
    CHECK(has(said_of("t,x", 0.0, 80.0), "are no vibration in g"));
    CHECK(has(said_of("t,x", 0.0, 8.0), "swings of 8 are much for g: these may be m/s2"));
    const std::string plain = said_of("t,x", 1.0, 3.0);
    CHECK(has(plain, "accelerations taken as g"));
    CHECK_FALSE(has(plain, "much for g"));
    AccelerationOptions in_g;
    in_g.unit = AccelerationUnit::g;
    CHECK_FALSE(has(said_of("t,x", 9.81, 8.0, in_g), "m/s2"));
}

TEST_CASE("units: a sensor's numbers that go unused are refused") {
    AccelerationOptions sensor;
    sensor.sensitivity_v_per_g = 0.1;
    sensor.offset_v = 1.65;
    CHECK(has(said_of("t,x", 0.0, 1.0, sensor), "with a recording in V alone"));
    CHECK(has(said_of("t,x (g)", 0.0, 1.0, sensor), "with a recording in V alone"));
    CHECK_FALSE(has(said_of("t,x (V)", 1.65, 0.1, sensor), "expected"));
}

}  // namespace border_units_test
