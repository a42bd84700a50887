// Files of on-off times: what is written, what its owner takes, and what comes back.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/effects_out/on_off.h"
#include "tests/model/io/effects_out/written_patterns.h"

namespace web_test {

using namespace tact;
using namespace tact::written_patterns;

namespace {

WrittenEffect written(const Pattern& pattern) {
    return write_effect(TargetFormat::web, pattern, {"x", bundled_actuator("phone-web")});
}

std::vector<int> entries(const WrittenEffect& written) {
    return nlohmann::json::parse(written.text).get<std::vector<int>>();
}

double length_s(const std::vector<int>& ms) {
    return 1e-3 * std::accumulate(ms.begin(), ms.end(), 0.0);
}

bool has_remark(const WrittenEffect& written, const std::string& words) {
    return std::ranges::any_of(written.remarks, [&](const std::string& remark) {
        return remark.find(words) != std::string::npos;
    });
}

Pattern tone(double amplitude_g, double duration_s) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.duration_s = duration_s;
    return pattern;
}

}  // namespace

TEST_CASE("web: an array of ms, on first, to the byte") {
    Pattern pattern = tone(1.0, 0.5);
    pattern.rhythm = {"-x=-x", 0.1};
    CHECK(written(pattern).text == "[0,100,200,100,100]\n");
    CHECK(written(tone(0.5, 0.1)).text == "[15,15,15,15,15,25]\n");
    CHECK(written(tone(0.0, 0.2)).text == "[0,200]\n");
}

TEST_CASE("web: what is lost is said, and nothing else") {
    Pattern pattern = tone(1.0, 0.5);
    pattern.rhythm = {"-x=-x", 0.1};
    CHECK(written(pattern).remarks ==
          std::vector<std::string>{"150 Hz left out: the device has its own frequency"});
    CHECK(has_remark(written(tone(0.5, 0.5)),
                     "amplitude becomes the share of time that the motor runs"));
    CHECK(has_remark(written(tone(0.02, 0.5)), "0.5 s are left out, which are too weak"));
    CHECK(has_remark(written(tone(2.0, 0.5)), "louder than full scale: scaled by 0.5"));
    pattern = tone(0.0, 0.2);
    pattern.transients = {{0.1, 1.0, 150.0, 0.008}};
    CHECK(has_remark(written(pattern), "a transient is written as a pulse"));
    CHECK(has_remark(written(pattern), "a part of less than 15 ms is played for 15 ms"));
    CHECK(entries(written(pattern)) == std::vector{0, 100, 15, 85});
}

TEST_CASE("web: at most 99 times of 10 s, by longer pulses, and then by what comes first") {
    CHECK(written(tone(1.0, 25.0)).text == "[10000,0,10000,0,5000]\n");
    const WrittenEffect longer = written(tone(0.3, 4.0));
    CHECK(entries(longer).size() <= kMostVibrateEntries);
    CHECK(length_s(entries(longer)) == doctest::Approx(4.0));
    CHECK(has_remark(longer, "pulses are up to 2 times as long as usual"));
    CHECK_FALSE(has_remark(longer, "are kept"));
    const WrittenEffect cut = written(tone(0.3, 60.0));
    CHECK(entries(cut).size() == kMostVibrateEntries);
    CHECK(has_remark(cut, " of 60 s are kept: browsers take 99 times"));
    Pattern row = tone(1.0, 10.0);
    row.rhythm = {"x-", 0.05};
    const WrittenEffect notes = written(row);
    const std::vector<int> ms = entries(notes);
    CHECK(ms == std::vector<int>(kMostVibrateEntries, 50));  // never another rhythm
    CHECK(has_remark(notes, "the first 4.95 of 10 s are kept"));
    CHECK_FALSE(has_remark(notes, "times as long"));
}

TEST_CASE("web: what was read is written again as it was, to the ms") {
    std::mt19937 random(48);
    for (int round = 0; round < 200; ++round) {
        std::vector<int> ms;
        if (whole(random, 0, 1) == 0) ms = {0, whole(random, 1, 500)};
        for (int k = whole(random, 1, 90); k > 0; --k) {
            const bool is_on = ms.size() % 2 == 0;
            ms.push_back(whole(random, is_on ? kLeastOnMs : kLeastOffMs, 400));
        }
        const std::string text = nlohmann::json(ms).dump() + "\n";
        const auto read = read_effects(text, "d/beat.vibrate.json");
        REQUIRE(read);
        CHECK(read->format == format_named("web"));
        CHECK(read->map.name == "phone-web");
        REQUIRE(read->effects.size() == 1);
        CHECK(read->effects[0].name == "beat");
        const Pattern& pattern = read->effects[0].pattern;
        REQUIRE_FALSE(drawn_fault(pattern));
        CHECK(pattern.duration_s == doctest::Approx(length_s(ms)));
        CHECK(written(pattern).text == text);
    }
}

}  // namespace web_test
