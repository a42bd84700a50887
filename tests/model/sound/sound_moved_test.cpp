#include "model/sound/from_sound.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/three_tones.h"

namespace sound_moved_test {

using namespace tact;

TEST_CASE(
    "sound moved: what is the same has PM 0 in every section, and another vibration has more") {
    PatternSet yardstick = three_tones();
    Pattern tone;
    tone.duration_s = 2.5;
    const auto same = sound_moved(render(tone), tone, yardstick);
    REQUIRE(same);
    CHECK(same->pm == std::vector<double>(7, 0.0));  // sections of 0.4 s, as the yardstick's
    Pattern other = tone;
    other.carriers[0].frequency_hz = 60.0;
    other.amplitude_curve = {{0.0, 1.0}, {1.0, 1.0}, {1.0, 0.1}};
    const auto far = sound_moved(render(tone), other, yardstick);
    REQUIRE(far);
    CHECK(far->pm[0] > 0.0);
    CHECK(far->pm.size() == 7);
    CHECK(words_on(*far).find("at most") != std::string::npos);
}

TEST_CASE(
    "sound moved: a sound of one carrier is hardly farther from its pattern than from itself") {
    Pattern tone;
    tone.amplitude_curve = {{0.0, 0.2}, {0.5, 1.0}, {1.0, 0.2}};
    const SoundPattern made = pattern_of_sound(render(tone));
    const auto one = sound_moved(made.felt, made.pattern, three_tones(), {1, {}, {}});
    const auto many = sound_moved(made.felt, made.pattern, three_tones(), {3, {}, {}});
    REQUIRE(one);
    REQUIRE(many);
    CHECK(one->pm == many->pm);
    CHECK(one->pm[0] <= one->closest_pm);
    std::stop_source stopped;
    stopped.request_stop();
    CHECK_FALSE(sound_moved(made.felt, made.pattern, three_tones(), {1, stopped.get_token(), {}}));
}

}  // namespace sound_moved_test
