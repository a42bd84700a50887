#include "model/tasks/set_pairs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "model/io/set/load.h"
#include "model/set/pattern_set.h"
#include "tests/support/places.h"

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

// Who calls predict() itself (maps, snapshots, phones, simulated studies) tells the same PM: it is
// a sum of whole numbers of steps, and where weights have few digits, as those that training finds,
// equal sums are equal to the last bit. Weights such as a third leave noise below a billionth,
// which shows in no number of a window. NC and OC are told by as_ranked(): OC of the Morse signals
// has noise that would be told as a number.
TEST_CASE(
    "set pairs: PM of a prediction needs no tie, in any bundled set and by weights of few digits" *
    doctest::test_suite("long")) {
    bool has_noise = false;
    std::size_t sets = 0;
    for (const char* folder : {"/sets", "/library"}) {
        for (const auto& entry :
             std::filesystem::directory_iterator(kAssetsDir + std::string(folder))) {
            if (!entry.path().filename().string().ends_with(".tactspace.json")) continue;
            CAPTURE(entry.path().filename().string());
            const auto loaded = load_set(entry.path());
            REQUIRE(loaded);
            PatternSet set = loaded->set;
            const auto known = predict(own_waveforms(set), set.model);
            REQUIRE(known);
            ++sets;
            for (const double weight : {set.model.nc_weight, 0.7, 0.375}) {
                set.model.nc_weight = weight;
                set.model.oc_weight = 1.0 - weight;
                const Prediction made =
                    prediction_of(known->codes, set.model, known->nc, known->oc);
                CHECK((as_ranked(Metric::pm, made.pm) == made.pm));
            }
            set.model.nc_weight = 1.0 / 3.0;
            set.model.oc_weight = 2.0 / 3.0;
            const Prediction thirds = prediction_of(known->codes, set.model, known->nc, known->oc);
            const Dissimilarity tied = as_ranked(Metric::pm, thirds.pm);
            CHECK((average_ranks(tied.condensed) == average_ranks(thirds.pm.condensed)));
            for (std::size_t k = 0; k < tied.condensed.size(); ++k) {
                CHECK(std::abs(tied.condensed[k] - thirds.pm.condensed[k]) <=
                      1e-9 * tied.condensed[k]);
            }
            for (const Metric metric : {Metric::nc, Metric::oc}) {
                const Dissimilarity& raw = metric == Metric::nc ? known->nc : known->oc;
                const Dissimilarity told = as_ranked(metric, raw);
                CHECK((average_ranks(told.condensed) == average_ranks(raw.condensed)));
                has_noise = has_noise || told != raw;
            }
        }
    }
    CHECK(sets >= 13);
    CHECK(has_noise);
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
