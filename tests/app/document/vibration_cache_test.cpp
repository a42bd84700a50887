#include "app/document/workspace.h"

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

namespace vibration_cache_test {

using namespace tact;

TEST_CASE("cache: the same value gives the same samples, a changed one its own") {
    VibrationCache cache;
    Vibration vibration;
    vibration.name = "a";
    vibration.source = Pattern{};
    const Waveform* first = &cached_waveform(cache, vibration);
    CHECK(*first == render(Pattern{}));
    CHECK(&cached_waveform(cache, vibration) == first);
    Pattern louder;
    louder.amplitude_g = 2.0;
    vibration.source = louder;
    CHECK(cached_waveform(cache, vibration) == render(louder));
}

TEST_CASE("cache: a frame renders so much and no more; what is behind is shown as it was") {
    VibrationCache cache;
    Vibration a;
    a.name = "a";
    Vibration b;
    b.name = "b";
    cache.samples_left = 1;  // the one that is begun is rendered whole
    REQUIRE(waveform_in_time(cache, a) != nullptr);
    CHECK_FALSE(cache.behind);
    CHECK(waveform_in_time(cache, b) == nullptr);
    CHECK(cache.behind);
    Pattern louder;
    louder.amplitude_g = 2.0;
    a.source = louder;
    CHECK(*waveform_in_time(cache, a) == render(Pattern{}));
    cache.samples_left = 1'000'000;
    cache.behind = false;
    CHECK(*waveform_in_time(cache, a) == render(louder));
    CHECK(*waveform_in_time(cache, b) == render(Pattern{}));
    CHECK_FALSE(cache.behind);
}

TEST_CASE("cache: a long pattern is rendered beside the window, and shown as it was meanwhile") {
    VibrationCache cache;
    Pattern pattern;
    pattern.duration_s = 4.0;
    Vibration vibration;
    vibration.name = "long";
    vibration.source = pattern;
    const Waveform before = cached_waveform(cache, vibration);
    const auto wake = [] {};
    follow_render_job(cache, wake);
    Pattern louder = pattern;
    louder.amplitude_g = 2.0;
    vibration.source = louder;
    CHECK(*waveform_in_time(cache, vibration) == before);
    CHECK_FALSE(cache.behind);  // no frames for nothing
    const auto becomes = [&](const Waveform& after) {
        for (int k = 0; k < 4000 && *waveform_in_time(cache, vibration) != after; ++k) {
            follow_render_job(cache, wake);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return *waveform_in_time(cache, vibration) == after;
    };
    const Waveform after = render(louder);
    CHECK(becomes(after));
    CHECK(peak_in_time(cache, vibration) == peak_g(after));
    // Short, which needs no job, and as it was again.
    vibration.source = Pattern{};
    CHECK(*waveform_in_time(cache, vibration) == render(Pattern{}));
    vibration.source = louder;
    CHECK(becomes(after));
}

TEST_CASE("cache: the scale of a set is its strongest peak, rendered or not, recordings among it") {
    VibrationCache cache;
    PatternSet set;
    Pattern weak;
    weak.amplitude_g = 0.25;
    Pattern strong;
    strong.amplitude_g = 1.5;
    strong.carriers = {{100.0, 0.5}, {300.0, 0.5}};
    for (const Pattern& pattern : {weak, strong}) {
        set.vibrations.push_back({});
        set.vibrations.back().name = "p" + std::to_string(set.vibrations.size());
        set.vibrations.back().source = pattern;
    }
    follow_reach(cache, set, 1);
    CHECK(cache.reach_g == doctest::Approx(1.5));  // not rendered: the most it can be
    for (const Vibration& vibration : set.vibrations) cached_waveform(cache, vibration);
    follow_reach(cache, set, 1);
    const double peak = peak_g(render(strong));
    CHECK(cache.reach_g == peak);
    // Twice as strong and not rendered yet it is twice as high, so that a drag shakes nothing.
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 3.0;
    follow_reach(cache, set, 2);
    CHECK(cache.reach_g == doctest::Approx(2.0 * peak).epsilon(1e-12));
    Measurement recording;
    Waveform samples = render(strong);
    for (double& sample : samples.samples_g) sample *= 10.0;
    recording.waveform = std::make_shared<const Waveform>(samples);
    set.vibrations[0].source = recording;
    follow_reach(cache, set, 3);
    CHECK(cache.reach_g == doctest::Approx(10.0 * peak).epsilon(1e-12));
    set.vibrations.clear();
    follow_reach(cache, set, 4);
    CHECK(cache.reach_g > 0.0);
}

TEST_CASE("cache: one axis of time for all pictures, which one long clip does not take") {
    PatternSet set;
    for (const double length_s : {0.1, 0.2, 0.2, 0.3, 60.0}) {
        Vibration one;
        one.name = "p" + std::to_string(set.vibrations.size());
        Pattern pattern;
        pattern.duration_s = length_s;
        one.source = pattern;
        set.vibrations.push_back(one);
    }
    VibrationCache cache;
    follow_reach(cache, set, 1);
    CHECK(cache.axis_s == doctest::Approx(6.0 * 0.2));
    std::get<Pattern>(set.vibrations.back().source).duration_s = 0.9;
    follow_reach(cache, set, 2);
    CHECK(cache.axis_s == doctest::Approx(0.9));
    follow_reach(cache, {}, 3);
    CHECK(cache.axis_s == 0.0);
}

TEST_CASE("cache: a pattern of transients alone counts for the scale before it is rendered") {
    VibrationCache cache;
    PatternSet set;
    Pattern taps;
    taps.amplitude_g = 0.0;
    taps.transients = {{0.1, 0.5}, {0.3, 2.0}};
    set.vibrations.push_back({});
    set.vibrations[0].name = "taps";
    set.vibrations[0].source = taps;
    follow_reach(cache, set, 1);
    CHECK(cache.reach_g == doctest::Approx(2.0));
}

}  // namespace vibration_cache_test
