// Arrays of navigator.vibrate, whoever wrote them, and arrays that are something else.
#include <doctest/doctest.h>

#include "model/pattern/pattern.h"
#include "tests/model/io/effects/effects_of.h"

namespace vibrate_test {

using namespace tact;

namespace {

const EffectFormat* format_of(const std::string& text) { return read(text).format; }

}  // namespace

TEST_CASE("vibrate: on first, at full scale and at a frequency that is guessed") {
    const EffectsRead all = read("[100, 50, 200, 150]");
    CHECK(all.format == format_named("web"));
    const Effect& effect = all.effects.at(0);
    CHECK(effect.pattern.duration_s == doctest::Approx(0.5));
    CHECK(envelope_g(effect.pattern, 0.05) == doctest::Approx(1.0));
    CHECK(envelope_g(effect.pattern, 0.12) == 0.0);
    CHECK(envelope_g(effect.pattern, 0.25) == doctest::Approx(1.0));
    CHECK(envelope_g(effect.pattern, 0.4) == 0.0);
    CHECK(first_carrier_hz(effect.pattern, 0.05) == doctest::Approx(165.0));
    CHECK(has_remark(effect, "165 Hz are guessed: such files have no frequency"));
    CHECK(all.map.source.find("guessed, not confirmed on a device") != std::string::npos);
}

TEST_CASE("vibrate: what browsers do with odd times is done and said") {
    const Effect odd = only("[100.7, 50, 20000]");
    CHECK(odd.pattern.duration_s == doctest::Approx(20.15));
    CHECK(has_remark(odd, "fractions of a ms are cut off"));
    CHECK(has_remark(odd, "Chrome cuts times of more than 10,000 ms"));
    std::string many = "[20";
    for (int k = 1; k < 120; ++k) many += ",20";
    const Effect long_one = only(many + "]");
    CHECK(has_remark(long_one, "Chrome plays the first 99 of its 120 times"));
    CHECK(long_one.pattern.duration_s == doctest::Approx(2.4));
    CHECK(has_remark(only("[0, 200]"), "it is silent"));
}

TEST_CASE("vibrate: what cannot be such times is refused in a sentence") {
    CHECK(fault("[100, -5]").starts_with("a.x: /1: expected a number from 0 to "));
    CHECK(fault("[0, 0]") == "a.x: expected a sum above 0 ms");
    CHECK(fault("[0.1, 0.2]").find("these may be seconds") != std::string::npos);
    CHECK(fault("[100, 1e300]").find("/1: expected a number") != std::string::npos);
    // Arrays of other things are other programs', but not by this name.
    const auto named = [](const std::string& text) {
        const auto read = read_effects(text, "a.vibrate.json");
        return read ? "" : read.error().message;
    };
    CHECK(named(R"([100, "on"])").starts_with("a.vibrate.json: /1: expected a number"));
    CHECK(named("[]") == "a.vibrate.json: expected a sum above 0 ms");
}

TEST_CASE("vibrate: arrays of anything but numbers are none of it") {
    for (const char* other : {"[]", "[[100, 50]]", R"([{"rt": 300}])", R"([100, "on"])",
                              "[100, null]", R"(["100"])", "100", R"({"vibrate": [100]})"}) {
        CAPTURE(other);
        CHECK(format_of(other) == nullptr);
    }
}

TEST_CASE("vibrate: a file is looked at if it begins as such an array does, or is named so") {
    const auto head = [](const std::string& text) { return head_of_effects(text, text.size()); };
    CHECK_FALSE(head(" [ 20, 30]").empty());
    CHECK(head(R"([{"trial_type": "a"}])").empty());
    CHECK(head("[[1, 2]]").empty());
    CHECK(head("[]").empty());
    CHECK(is_effect_name("d/a.vibrate.json"));
    CHECK(is_effect_name("A.Vibrate.JSON"));
    CHECK_FALSE(is_effect_name("a.json"));
    CHECK_FALSE(is_effect_name("vibrate.json"));
    CHECK(effect_stem("d/heart.beat.vibrate.json") == "heart.beat");
    CHECK(effect_stem("d/a.json") == "a");
    CHECK(effect_stem(".vibrate.json") == ".vibrate");
}

}  // namespace vibrate_test
