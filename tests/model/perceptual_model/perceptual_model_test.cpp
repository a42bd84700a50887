#include "model/perceptual_model/perceptual_model.h"

#include <chrono>
#include <numeric>
#include <stop_token>
#include <thread>

#include "model/perceptual_model/rhythm_envelope.h"
#include "model/set/pattern_set.h"
#include "tests/support/dtw_textbook.h"
#include "tests/support/golden.h"

namespace perceptual_model_test {

using namespace tact;
using golden::Json;

namespace {

std::vector<Waveform> waveforms_of(const Json& patterns) {
    std::vector<Waveform> waveforms;
    std::size_t longest = 0;
    for (const Json& pattern : patterns) {
        waveforms.push_back(render(golden::pattern_of(pattern)));
        longest = std::max(longest, waveforms.back().samples_g.size());
    }
    for (Waveform& waveform : waveforms) waveform = padded(waveform, longest);
    return waveforms;
}

PerceptualModelParams params_with_weights(const Json& json) {
    PerceptualModelParams params = golden::params_of(json);
    params.nc_weight = json.value("w_NC", params.nc_weight);
    params.oc_weight = json.value("w_OC", params.oc_weight);
    return params;
}

// Short patterns: the laws below hold at any length, and DTW is quadratic.
std::vector<Waveform> short_set(std::size_t patterns, double duration_s = 0.12) {
    std::vector<Waveform> waveforms;
    for (std::size_t k = 0; k < patterns; ++k) {
        Pattern pattern;
        pattern.duration_s = duration_s;
        pattern.amplitude_g = 0.5 + 0.3 * static_cast<double>(k % 4);
        pattern.carriers[0].frequency_hz = 50.0 + 40.0 * static_cast<double>(k);
        pattern.modulation.frequency_hz = 10.0 * static_cast<double>(k % 3);
        waveforms.push_back(render(pattern));
    }
    return waveforms;
}

}  // namespace

TEST_CASE("perceptual model: NC, OC and PM equal the independent program's" *
          doctest::test_suite("long")) {
    const Json predictions = golden::read("predictions.json");
    for (const Json& set : predictions.at("sets")) {
        const std::string name = set.at("name");
        CAPTURE(name);
        const auto waveforms = waveforms_of(set.at("patterns"));
        // OC of full-length pairs takes seconds: computed by default, and where it changes.
        for (const Json& expected : set.at("results")) {
            const PerceptualModelParams params = params_with_weights(expected.at("params"));
            CAPTURE(expected.at("params").dump());
            PredictOptions options;
            const auto codes = pattern_codes(waveforms, params, options);
            const auto nc = nc_matrix(codes, params, options);
            CHECK(golden::worst_difference(nc.condensed, expected.at("nc")) <= 1e-9);
            const bool affects_oc = params.envelope.scale == EnvelopeScale::raw;
            if (!expected.at("params").empty() && !affects_oc) continue;
            const auto prediction = predict(waveforms, params, options);
            REQUIRE(prediction.has_value());
            CHECK(golden::worst_difference(prediction->oc.condensed, expected.at("oc")) <= 1e-9);
            // Rank sums are halves: exact.
            CHECK(prediction->pm.condensed == expected.at("pm").get<std::vector<double>>());
        }
    }
}

TEST_CASE("perceptual model: 40 and 80 Hz modulation feel like the plain tone, slow does not") {
    const Json predictions = golden::read("predictions.json");
    const Json& set = predictions.at("sets")[0];
    REQUIRE(set.at("name") == "am-8-5Hz");
    const auto prediction = predict(waveforms_of(set.at("patterns")), {});
    const std::vector<double> printed{19, 22, 22, 18, 10, 2, 3.5};  // of the model page, section 7
    for (std::size_t k = 0; k < printed.size(); ++k) CHECK(prediction->pm(0, k + 1) == printed[k]);
}

TEST_CASE("perceptual model: same bits for any number of threads") {
    const auto waveforms = short_set(9);
    PredictOptions one;
    one.threads = 1;
    const auto expected = predict(waveforms, {}, one);
    for (const int threads : {2, 4}) {
        PredictOptions options;
        options.threads = threads;
        const auto got = predict(waveforms, {}, options);
        CHECK(got->nc == expected->nc);
        CHECK(got->oc == expected->oc);
        CHECK(got->pm == expected->pm);
    }
}

TEST_CASE("perceptual model: an edit that reuses the rest gives the bits of a fresh run") {
    auto waveforms = short_set(7);
    const auto before = predict(waveforms, {});
    waveforms[3] = short_set(12)[11];
    std::swap(waveforms[0], waveforms[5]);
    waveforms.push_back(waveforms[1]);  // a twin
    PredictOptions reuse;
    reuse.previous = &*before;
    const auto incremental = predict(waveforms, {}, reuse);
    const auto fresh = predict(waveforms, {});
    CHECK(incremental->nc == fresh->nc);
    CHECK(incremental->oc == fresh->oc);
    CHECK(incremental->pm == fresh->pm);
    std::size_t kept = 0;
    for (const auto& code : incremental->codes) {
        kept += static_cast<std::size_t>(std::ranges::count(before->codes, code));
    }
    CHECK(kept == 7);  // six unchanged patterns, and the twin of one
}

TEST_CASE("perceptual model: zeros up to the longest waveform are those that it adds itself") {
    std::vector<Waveform> own = short_set(6);
    for (std::size_t k = 1; k < own.size(); ++k) own[k].samples_g.resize(900 - 100 * k);
    const std::size_t longest = own[0].samples_g.size();
    std::vector<Waveform> whole = own;
    for (Waveform& one : whole) one = padded(one, longest);
    const auto expected = predict(whole, {});
    const auto got = predict(own, {});
    CHECK(got->nc == expected->nc);
    CHECK(got->oc == expected->oc);
    CHECK(got->pm == expected->pm);
    // Either way it is the same pattern. In a longer set it is coded again.
    PredictOptions reuse;
    reuse.previous = &*got;
    CHECK(predict(whole, {}, reuse)->codes == got->codes);
    own.back().samples_g.resize(longest + 500);
    CHECK(predict(own, {}, reuse)->codes[2] != got->codes[2]);
    CHECK(predict(own, {}, reuse)->pm == predict(own, {})->pm);
}

TEST_CASE("perceptual model: what changed parameters spoil is not reused") {
    const auto waveforms = short_set(5);
    const auto before = predict(waveforms, {});
    PredictOptions reuse;
    reuse.previous = &*before;
    PerceptualModelParams other;
    SUBCASE("channel weights") { other.channel_weight = {1.0, 0.0, 0.0, 0.0}; }
    SUBCASE("layers") { other.coding.excitatory_layers = 1; }
    SUBCASE("envelope") { other.envelope.scale = EnvelopeScale::raw; }
    SUBCASE("waiting") { other.envelope.waiting_cost = 0.2; }
    SUBCASE("integration") { other.nc_weight = 0.9; }
    SUBCASE("preview") { reuse.envelope_decimation = 10; }
    PredictOptions alone;
    alone.envelope_decimation = reuse.envelope_decimation;
    const auto incremental = predict(waveforms, other, reuse);
    const auto fresh = predict(waveforms, other, alone);
    CHECK(incremental->nc == fresh->nc);
    CHECK(incremental->oc == fresh->oc);
    CHECK(incremental->pm == fresh->pm);
}

TEST_CASE("perceptual model: how long a note lasts counts once waiting costs") {
    PatternSet set;
    for (const char* rhythm : {"x---", "x==-", "x-x-"}) {
        Pattern pattern;
        pattern.duration_s = 0.2;
        pattern.rhythm = {rhythm, 0.05};
        Vibration vibration;
        vibration.name = rhythm;
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    const auto waveforms = model_waveforms(set);
    const auto share = [&](double waiting_cost) {
        PerceptualModelParams params;
        params.envelope.waiting_cost = waiting_cost;
        const auto oc = predict(waveforms, params)->oc;
        return oc(0, 1) / oc(0, 2);
    };
    CHECK(share(0.0) < 0.1);
    CHECK(share(0.1) > 0.3);
}

TEST_CASE("perceptual model: a preview keeps most of the order of pairs") {
    const auto waveforms = short_set(8, 0.4);
    PredictOptions coarse;
    coarse.envelope_decimation = 10;
    const auto preview = predict(waveforms, {}, coarse);
    const auto exact = predict(waveforms, {});
    CHECK(preview->envelope_decimation == 10);
    CHECK(preview->nc == exact->nc);
    double difference = 0.0;
    for (std::size_t k = 0; k < exact->oc_rank.size(); ++k) {
        difference += std::abs(preview->oc_rank[k] - exact->oc_rank[k]);
    }
    // Random orders of 28 pairs are 9 ranks apart on average.
    CHECK(difference / static_cast<double>(exact->oc_rank.size()) < 2.0);
}

TEST_CASE("perceptual model: no, one and two patterns have no, no and one pair") {
    CHECK(predict({}, {})->pm.condensed.empty());
    CHECK(predict(short_set(1), {})->pm.condensed.empty());
    CHECK(predict(short_set(2), {})->pm.condensed == std::vector<double>{1.0});
}

TEST_CASE("perceptual model: a stop gives nothing rather than half an answer") {
    std::stop_source stop;
    stop.request_stop();
    PredictOptions options;
    options.stop = stop.get_token();
    CHECK_FALSE(predict(short_set(4), {}, options).has_value());
}

namespace {

// Patterns of 20 to 70 ms in a set with one of 0.4 s, which sounds to its end.
std::vector<Waveform> with_a_long_one() {
    std::vector<Waveform> waveforms = short_set(6);
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        waveforms[k].samples_g.resize(200 + 100 * k);
    }
    waveforms.push_back(short_set(1, 0.4).front());
    return waveforms;
}

}  // namespace

TEST_CASE("perceptual model: codes are as short as their patterns, and no bit differs from whole") {
    const auto waveforms = with_a_long_one();
    const std::size_t longest = waveforms.back().samples_g.size();
    PerceptualModelParams params;
    SUBCASE("usual") {}
    SUBCASE("waiting") { params.envelope.waiting_cost = 0.2; }
    SUBCASE("weights without a unit") { params.channel_weight = {0.1, 1.0 / 3.0, 0.77, 0.9}; }
    const auto prediction = predict(waveforms, params);
    REQUIRE(prediction);
    std::vector<NeuralCode> neural;
    std::vector<std::vector<double>> envelopes;
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        const Waveform whole = padded(waveforms[k], longest);
        neural.push_back(neural_code(whole, params.coding));
        envelopes.push_back(rhythm_envelope(whole.samples_g, params.envelope));
        const PatternCode& code = *prediction->codes[k];
        CHECK(code.envelope.size() <= waveforms[k].samples_g.size() + kEnvelopeSamples);
        CHECK(code.neural.samples == neural[k].central_spikes.size());
    }
    // Some fire up to the end of the longest: a low-pass channel follows the mean that was removed.
    const auto ends_early = [](const auto& code) {
        return code->neural.central_spikes.size() < code->neural.samples;
    };
    CHECK(std::ranges::any_of(prediction->codes, ends_early));
    for (std::size_t i = 0; i < waveforms.size(); ++i) {
        for (std::size_t j = i + 1; j < waveforms.size(); ++j) {
            CHECK(prediction->nc(i, j) ==
                  nc_dissimilarity(neural[i], neural[j], params.channel_weight));
            CHECK(prediction->oc(i, j) ==
                  dtw_textbook(envelopes[i], envelopes[j], params.envelope.waiting_cost));
        }
    }
}

TEST_CASE("perceptual model: stopped at whatever moment, codes are whole or none") {
    Pattern pattern;
    pattern.duration_s = 10.0;
    const std::vector<Waveform> waveforms{render(pattern)};
    const auto whole = pattern_codes(waveforms, {}, {});
    REQUIRE(whole.size() == 1);
    for (int wait = 0; wait < 40; ++wait) {
        std::stop_source stop;
        const std::jthread other([&stop, wait] {
            std::this_thread::sleep_for(std::chrono::microseconds(200 * wait));
            stop.request_stop();
        });
        PredictOptions options;
        options.stop = stop.get_token();
        const auto codes = pattern_codes(waveforms, {}, options);
        if (codes.empty()) continue;
        REQUIRE(codes.size() == 1);
        REQUIRE(codes[0]);
        CHECK(codes[0]->neural.central_count == whole[0]->neural.central_count);
        CHECK(codes[0]->neural.central_spikes == whole[0]->neural.central_spikes);
        CHECK(codes[0]->envelope == whole[0]->envelope);
    }
}

}  // namespace perceptual_model_test
