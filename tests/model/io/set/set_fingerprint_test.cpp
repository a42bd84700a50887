#include "model/io/set/set_file.h"

#include <doctest/doctest.h>

#include <memory>
#include <utility>
#include <variant>

namespace set_fingerprint_test {

using namespace tact;

namespace {

Vibration vibration(const char* name, VibrationSource source) {
    Vibration result;
    result.name = name;
    result.source = std::move(source);
    return result;
}

PatternSet two_patterns() {
    PatternSet set;
    Pattern loud;
    loud.amplitude_g = 2.0;
    set.vibrations = {vibration("a", Pattern{}), vibration("b", loud)};
    return set;
}

Vibration recording(double last_g) {
    Measurement measurement;
    measurement.waveform =
        std::make_shared<const Waveform>(Waveform{kModelRateHz, {0.0, 0.1, last_g}});
    return vibration("r", measurement);
}

}  // namespace

TEST_CASE("set fingerprint: parameters, samples and order count; names and notes do not") {
    const PatternSet set = two_patterns();
    const std::uint64_t number = vibrations_fingerprint(set);
    PatternSet renamed = set;
    renamed.name = "other";
    renamed.vibrations[0].name = "first";
    renamed.vibrations[0].note = "soft";
    renamed.vibrations[1].locked = true;
    renamed.model.nc_weight = 0.25;
    CHECK(vibrations_fingerprint(renamed) == number);

    PatternSet louder = set;
    std::get<Pattern>(louder.vibrations[1].source).amplitude_g = 2.0000000000000004;
    CHECK(vibrations_fingerprint(louder) != number);
    PatternSet turned = set;
    std::swap(turned.vibrations[0], turned.vibrations[1]);
    CHECK(vibrations_fingerprint(turned) != number);

    PatternSet recorded = set;
    recorded.vibrations[0] = recording(0.2);
    PatternSet recorded_again = set;
    recorded_again.vibrations[0] = recording(0.20000000000000004);
    CHECK(vibrations_fingerprint(recorded) != number);
    CHECK(vibrations_fingerprint(recorded) != vibrations_fingerprint(recorded_again));
    PatternSet later = set;
    later.vibrations = {set.vibrations[0], recording(0.2)};
    PatternSet earlier = set;
    earlier.vibrations = {recording(0.2), set.vibrations[0]};
    CHECK(vibrations_fingerprint(later) != vibrations_fingerprint(earlier));
}

TEST_CASE("set fingerprint: the model's is of the model alone") {
    PatternSet set = two_patterns();
    const std::uint64_t number = model_fingerprint(set);
    set.vibrations.pop_back();
    CHECK(model_fingerprint(set) == number);
    set.model.channel_weight[1] = 0.71;
    CHECK(model_fingerprint(set) != number);
    set = two_patterns();
    set.model.coding.tables.slope[0].value[0] += 1.0;
    CHECK(model_fingerprint(set) != number);
}

}  // namespace set_fingerprint_test
