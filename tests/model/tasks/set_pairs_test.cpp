#include "model/tasks/set_pairs.h"

#include <doctest/doctest.h>

#include "model/set/pattern_set.h"

namespace set_pairs_test {

using namespace tact;

namespace {

// Patterns of three lengths, one of which nobody feels.
PatternSet some_set() {
    PatternSet set;
    for (const double f_hz : {60.0, 150.0, 210.0, 250.0, 90.0}) {
        Pattern pattern;
        pattern.duration_s = f_hz < 100.0 ? 0.08 : f_hz < 240.0 ? 0.1 : 0.15;
        pattern.carriers[0].frequency_hz = f_hz;
        pattern.amplitude_g = f_hz == 210.0 ? 0.0 : 1.0;
        Vibration vibration;
        vibration.name = std::to_string(set.vibrations.size());
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    set.model.envelope.waiting_cost = 0.2;
    return set;
}

}  // namespace

TEST_CASE("set pairs: they are what the metric says, with what nobody feels beside them") {
    const PatternSet set = some_set();
    const std::vector<Waveform> own = own_waveforms(set);
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        const auto pairs = set_pairs(set, {metric});
        REQUIRE(pairs);
        CHECK(pairs->apart == as_ranked(metric, *metric_matrix(metric, own, set.model)));
        CHECK(pairs->unfelt == std::vector<std::size_t>{2});
        CHECK(set_pairs(own, set.model, {metric}) == pairs);
        CHECK(set_pairs(set, {metric, false})->unfelt.empty());
    }
    CHECK(unfelt_in(set) == std::vector<std::size_t>{2});
    CHECK(unfelt_in(own, set.model) == std::vector<std::size_t>{2});
}

TEST_CASE("set pairs: what a prediction knows has the same bits, and padded waveforms have them") {
    const PatternSet set = some_set();
    const auto prediction = predict(model_waveforms(set), set.model);
    REQUIRE(prediction);
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        const auto pairs = set_pairs(set, {metric});
        CHECK(set_pairs(set, {metric, true, &*prediction}) == pairs);
        // It takes waveforms as they are.
        if (metric == Metric::dtw) continue;
        CHECK(set_pairs(model_waveforms(set), set.model, {metric}) == pairs);
    }
}

TEST_CASE("set pairs: stopped, there are none") {
    std::stop_source stop;
    stop.request_stop();
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        PairsRequest request{metric};
        request.options.stop = stop.get_token();
        CHECK_FALSE(set_pairs(some_set(), request));
    }
    CHECK_FALSE(unfelt_in(some_set(), 1, stop.get_token()));
}

TEST_CASE("set pairs: a set of none has none") {
    CHECK(set_pairs(PatternSet{}) == SetPairs{});
    CHECK(unfelt_in(PatternSet{}) == std::vector<std::size_t>{});
}

}  // namespace set_pairs_test
