#include "app/document/vibration_cache.h"

#include <doctest/doctest.h>

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

TEST_CASE("cache: components follow the vibration and the model's choices") {
    VibrationCache cache;
    Vibration vibration;
    vibration.name = "a";
    vibration.source = Pattern{};
    NeuralCodingParams params;
    CHECK(cached_components(cache, vibration, params).size() == 1);
    Pattern leaking;
    leaking.carriers[0].frequency_hz = 150.5;
    vibration.source = leaking;
    CHECK(cached_components(cache, vibration, params).size() > 100);
    params.components = Components::peaks;
    CHECK(cached_components(cache, vibration, params).size() < 10);
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

}  // namespace vibration_cache_test
