#include "app/vibration_cache.h"

#include <doctest/doctest.h>

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
