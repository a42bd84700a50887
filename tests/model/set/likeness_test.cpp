#include "model/set/likeness.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace likeness_test {

using namespace tact;

namespace {

Vibration tone(double amplitude_g, double frequency_hz, double duration_s) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers = {{frequency_hz, 1.0, 0.0}};
    pattern.duration_s = duration_s;
    Vibration vibration;
    vibration.source = pattern;
    return vibration;
}

Vibration sampled(const Vibration& pattern) {
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(waveform_of(pattern));
    Vibration vibration;
    vibration.source = measurement;
    return vibration;
}

PatternSet set_of(std::vector<Vibration> vibrations) {
    PatternSet set;
    set.vibrations = std::move(vibrations);
    return set;
}

}  // namespace

TEST_CASE("likeness: what is alike follows each other, whatever the order of the set") {
    // A scale of frequencies, shuffled: from one end it is walked to the other.
    const PatternSet set =
        set_of({tone(1, 40, 1), tone(1, 320, 1), tone(1, 80, 1), tone(1, 160, 1)});
    CHECK(order_by_likeness(set) == std::vector<std::size_t>{0, 2, 3, 1});
    const PatternSet lengths =
        set_of({tone(1, 90, 0.1), tone(1, 90, 0.9), tone(1, 90, 0.3), tone(1, 90, 0.6)});
    CHECK(order_by_likeness(lengths) == std::vector<std::size_t>{0, 2, 3, 1});
    const PatternSet strengths = set_of({tone(0.1, 90, 1), tone(2, 90, 1), tone(0.3, 90, 1)});
    CHECK(order_by_likeness(strengths) == std::vector<std::size_t>{0, 2, 1});
}

TEST_CASE(
    "likeness: a recording lies beside the pattern that it is of, and layers beside their sum") {
    const Vibration low = tone(1, 50, 0.5);
    const Vibration high = tone(1, 250, 0.5);
    Vibration layers;
    layers.source = LayeredPattern{{{"a", std::get<Pattern>(high.source)}}};
    const PatternSet set = set_of({low, high, sampled(low), layers});
    CHECK(order_by_likeness(set) == std::vector<std::size_t>{0, 2, 1, 3});
}

TEST_CASE("likeness: every place is there once, of none, of silence and of equal ones") {
    CHECK(order_by_likeness({}).empty());
    const PatternSet equal = set_of(std::vector<Vibration>(9, tone(0, 90, 1)));
    CHECK(order_by_likeness(equal) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8});
}

}  // namespace likeness_test
