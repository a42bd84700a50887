#include "model/set/pattern_set.h"

#include "tests/support/golden.h"

namespace pattern_set_test {

using namespace tact;

namespace {

Vibration named(const std::string& name, double duration_s) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

}  // namespace

TEST_CASE("pattern set: shorter patterns are padded with silence to the longest") {
    PatternSet set;
    set.vibrations = {named("short", 0.3), named("long", 1.0)};
    const auto waveforms = model_waveforms(set);
    REQUIRE(waveforms.size() == 2);
    CHECK(waveforms[0].samples_g.size() == 10'000);
    CHECK(waveforms[0].samples_g[2999] != 0.0);
    CHECK(waveforms[0].samples_g[3001] == 0.0);
    CHECK(model_waveforms(PatternSet{}).empty());
    CHECK(longest_samples(set) == 10'000);
    CHECK(longest_samples(PatternSet{}) == 0);
}

TEST_CASE("pattern set: a new name is the first that is free") {
    PatternSet set;
    set.vibrations = {named("tap", 1.0), named("tap 2", 1.0)};
    CHECK(unused_name(set, "tap") == "tap 3");
    CHECK(unused_name(set, "tap 2") == "tap 3");  // the number of a copy continues
    CHECK(unused_name(set, "buzz") == "buzz");
}

TEST_CASE("pattern set: measurements are equal by what was measured, not by where it is kept") {
    const auto waveform = std::make_shared<const Waveform>(render(Pattern{}));
    const Measurement a{waveform, "a.wav", 2.0, ""};
    Measurement b = a;
    b.waveform = std::make_shared<const Waveform>(*waveform);
    CHECK(a == b);
    Waveform other = *waveform;
    other.samples_g[7] += 1e-9;
    b.waveform = std::make_shared<const Waveform>(other);
    CHECK_FALSE(a == b);
}

}  // namespace pattern_set_test
