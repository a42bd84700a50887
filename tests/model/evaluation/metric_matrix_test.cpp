#include "model/evaluation/metric_matrix.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "model/metrics/rank_average.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "tests/support/golden.h"

namespace metric_matrix_test {

using namespace tact;
using golden::Json;

namespace {

// Both programs sum in another order and take other routes through the transforms: 1e-12 of the
// largest value is what that leaves; where cosines in dB and logistic functions follow, 1e-10.
constexpr double kTolerance = 1e-10;

struct GoldenSet {
    Json json;
    std::vector<Waveform> waveforms;  // as rendered, not padded
};

const std::vector<GoldenSet>& golden_sets() {
    static const std::vector<GoldenSet> sets = [] {
        std::vector<GoldenSet> read;
        const Json file = golden::read("metrics.json");
        for (const Json& json : file.at("sets")) {
            GoldenSet& set = read.emplace_back(GoldenSet{json, {}});
            for (const Json& pattern : json.at("patterns")) {
                set.waveforms.push_back(render(golden::pattern_of(pattern)));
            }
        }
        return read;
    }();
    REQUIRE(sets.size() == 4);
    return sets;
}

double worst(const Dissimilarity& got, const Json& expected) {
    return golden::worst_difference(got.condensed, expected.get<std::vector<double>>());
}

std::vector<Waveform> every_tenth(const std::vector<Waveform>& waveforms) {
    std::vector<Waveform> thin;
    for (const Waveform& waveform : waveforms) {
        thin.push_back({waveform.rate_hz / 10.0, golden::every(10, waveform.samples_g)});
    }
    return thin;
}

// Waveforms of 0.1 s, as DTW is quadratic; two of them silent, two the same, one shorter.
std::vector<Waveform> short_set() {
    std::vector<Waveform> waveforms;
    for (const double f_hz : {60.0, 150.0, 210.0, 150.0}) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.carriers[0].frequency_hz = f_hz;
        waveforms.push_back(render(pattern));
    }
    waveforms.push_back(golden::noise(5, 700, 0.4));
    waveforms.push_back(Waveform{kModelRateHz, std::vector<double>(1000, 0.0)});
    waveforms.push_back(Waveform{kModelRateHz, std::vector<double>(600, 0.0)});
    return waveforms;
}

Dissimilarity matrix_of(Metric metric, const std::vector<Waveform>& waveforms,
                        const MetricOptions& options = {}) {
    const auto matrix = metric_matrix(metric, waveforms, {}, options);
    REQUIRE(matrix);
    return *matrix;
}

bool is_rank_sum(Metric metric) { return metric == Metric::pm || metric == Metric::no_physiology; }

// The options that the golden file names, each away from its default.
std::map<std::string, std::pair<Metric, MetricOptions>> changed_options() {
    std::map<std::string, std::pair<Metric, MetricOptions>> changed;
    const auto change = [&](const char* label, Metric metric) -> MetricOptions& {
        auto& [kept, options] = changed[label];
        kept = metric;
        return options;
    };
    auto& decibel = change("rmse/decibel", Metric::rmse).baseline.rmse;
    decibel.scale = SpectrumScale::decibel;
    decibel.low_hz = 1.0;
    decibel.high_hz = 1000.0;
    auto& normalised = change("rmse/normalised", Metric::rmse);
    normalised.baseline.rmse.error = SpectralError::normalised;
    normalised.direction = Direction::first_is_reference;
    change("rmse/smoothed", Metric::rmse).baseline.rmse.smoothing_lines = 5;
    change("rmse/gfc", Metric::rmse).baseline.rmse.error = SpectralError::goodness_of_fit;
    change("msm/wide", Metric::msm).baseline.msm.width = 0.20;
    change("msm/mean", Metric::msm).baseline.msm.mean = SubBandMean::arithmetic;
    change("msm/normalised", Metric::msm).baseline.msm.is_normalised = true;
    change("mtm/magnitude", Metric::mtm).baseline.mtm.sign = CorrelationSign::dropped;
    change("mtm/with mean", Metric::mtm).baseline.mtm.removes_mean = false;
    change("st-sim/upper", Metric::st_sim).direction = Direction::first_is_reference;
    change("st-sim/clamped", Metric::st_sim).baseline.st_sim.negative_shape =
        NegativeShape::clamped;
    change("st-sim/8000", Metric::st_sim).baseline.st_sim.spectrum.rate = ThresholdRate::published;
    change("st-sim/m_per_s2", Metric::st_sim).baseline.st_sim.spectrum.unit =
        AmplitudeUnit::m_per_s2;
    change("st-sim/skip silent", Metric::st_sim).baseline.st_sim.shared_silence =
        SharedSilence::left_out;
    change("spqi/upper", Metric::spqi).direction = Direction::first_is_reference;
    change("spqi/error", Metric::spqi).baseline.spqi.distance = SpqiDistance::error_db;
    return changed;
}

}  // namespace

TEST_CASE("metric matrix: four sets by every metric equal the independent program's" *
          doctest::test_suite("long")) {
    for (const GoldenSet& set : golden_sets()) {
        const std::string name = set.json.at("name");
        CAPTURE(name);
        for (const auto& [key, expected] : set.json.at("matrices").items()) {
            const auto metric = metric_named(key);
            if (!metric) continue;  // an option, below
            CAPTURE(key);
            CHECK(worst(matrix_of(*metric, set.waveforms), expected) <= kTolerance);
        }
        const Json& matrices = set.json.at("matrices");
        CHECK(worst(matrix_of(Metric::dtw, every_tenth(set.waveforms)),
                    matrices.at("dtw of every tenth")) <= kTolerance);
        MetricOptions lines;
        lines.baseline.van_rossum.lines = SpikeLines::one_by_one;
        CHECK(worst(matrix_of(Metric::van_rossum, set.waveforms, lines),
                    matrices.at("van-rossum/lines")) <= kTolerance);
    }
}

// Numbers of an independent program for one metric: a matrix in each set of a golden file.
struct Oracle {
    Metric metric;
    const char* file;
    const char* in_set;  // a JSON pointer
};

// Those that are not in metrics.json under the metric's key.
constexpr std::array kOraclesElsewhere{
    // The model has an oracle of its own, reference_model.py: perceptual_model_test.
    Oracle{Metric::pm, "predictions.json", "/results/0/pm"},
    Oracle{Metric::nc, "predictions.json", "/results/0/nc"},
    Oracle{Metric::oc, "predictions.json", "/results/0/oc"},
    // By every tenth sample: the time it takes grows with the square of their number.
    Oracle{Metric::dtw, "metrics.json", "/matrices/dtw of every tenth"},
    // Made of the matrices of others, OC among them, which not every set has.
    Oracle{Metric::no_physiology, "metrics.json", "/no-physiology"}};

TEST_CASE("metric matrix: every metric has numbers of an independent program") {
    std::map<std::string, Json> sets_of;
    for (const char* file : {"metrics.json", "predictions.json"}) {
        sets_of[file] = golden::read(file, "sets");
    }
    for (const Metric metric : kMetrics) {
        const std::string key = traits(metric).key;
        CAPTURE(key);
        const std::string by_key = "/matrices/" + key;
        const auto elsewhere = std::ranges::find(kOraclesElsewhere, metric, &Oracle::metric);
        const bool is_elsewhere = elsewhere != kOraclesElsewhere.end();
        const Json& sets = sets_of.at(is_elsewhere ? elsewhere->file : "metrics.json");
        const Json::json_pointer at(is_elsewhere ? elsewhere->in_set : by_key);
        std::size_t held = 0;
        for (const Json& set : sets) {
            if (!set.contains(at)) continue;
            CHECK(set.at(at).size() == pair_count(set.at("patterns").size()));
            ++held;
        }
        CHECK(held >= 2);
        if (!is_elsewhere) continue;
        // What has its numbers under its key needs no place in the list.
        for (const Json& set : sets_of.at("metrics.json")) {
            CHECK_FALSE(set.contains(Json::json_pointer(by_key)));
        }
    }
}

TEST_CASE("metric matrix: every option equals the independent program's" *
          doctest::test_suite("long")) {
    const auto options = changed_options();
    for (const GoldenSet& set : golden_sets()) {
        const std::string name = set.json.at("name");
        CAPTURE(name);
        for (const auto& [label, expected] : set.json.at("changed").items()) {
            CAPTURE(label);
            REQUIRE(options.contains(label));
            const auto& [metric, changed] = options.at(label);
            CHECK(worst(matrix_of(metric, set.waveforms, changed), expected) <= kTolerance);
        }
    }
}

TEST_CASE("metric matrix: small SPQI have an order of their own, which 1 - SPQI would lose") {
    const Dissimilarity crowded{3, {1.0 - 1e-2, 1.0 - 2e-10, 1.0 - 1e-10}};
    CHECK(average_ranks(crowded.condensed) == std::vector<double>{1.0, 2.5, 2.5});
    CHECK(average_ranks(values_to_rank(Metric::spqi, crowded)) ==
          std::vector<double>{1.0, 2.0, 3.0});
    CHECK(values_to_rank(Metric::mtm, crowded) == crowded.condensed);
    BaselineParams in_db;
    in_db.spqi.distance = SpqiDistance::error_db;
    CHECK(values_to_rank(Metric::spqi, crowded, in_db) == crowded.condensed);
}

TEST_CASE("metric matrix: equal waveforms are at 0, and all values are numbers") {
    const auto waveforms = short_set();
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        const auto matrix = matrix_of(metric, waveforms);
        REQUIRE(matrix.size == waveforms.size());
        for (const double value : matrix.condensed) {
            CHECK(std::isfinite(value));
            if (metric != Metric::st_sim) CHECK(value >= 0.0);
        }
        if (is_rank_sum(metric)) continue;
        CHECK(matrix(1, 3) == 0.0);
        CHECK(matrix(5, 6) == 0.0);
        CHECK(matrix(0, 5) > 0.0);
    }
}

TEST_CASE("metric matrix: the order of the patterns changes no bit") {
    auto waveforms = short_set();
    std::vector<Waveform> reversed(waveforms.rbegin(), waveforms.rend());
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        const auto matrix = matrix_of(metric, waveforms);
        const auto back = matrix_of(metric, reversed);
        const std::size_t n = waveforms.size();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                CHECK(matrix(i, j) == back(n - 1 - i, n - 1 - j));
            }
        }
    }
}

TEST_CASE("metric matrix: the same bits for any number of threads") {
    const auto waveforms = short_set();
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        MetricOptions one;
        one.threads = 1;
        const auto expected = matrix_of(metric, waveforms, one);
        for (const int threads : {2, 4}) {
            MetricOptions several;
            several.threads = threads;
            CHECK(matrix_of(metric, waveforms, several) == expected);
        }
    }
}

TEST_CASE("metric matrix: PM and its parts are those of the perceptual model") {
    auto waveforms = short_set();
    for (Waveform& waveform : waveforms) waveform = padded(waveform, 1000);
    const auto prediction = predict(waveforms, {});
    REQUIRE(prediction);
    CHECK(matrix_of(Metric::pm, waveforms) == prediction->pm);
    CHECK(matrix_of(Metric::nc, waveforms) == prediction->nc);
    CHECK(matrix_of(Metric::oc, waveforms) == prediction->oc);
}

TEST_CASE("metric matrix: without physiology it is the mean rank of Msm, Mtm and OC") {
    const auto waveforms = short_set();
    const std::array parts{matrix_of(Metric::msm, waveforms), matrix_of(Metric::mtm, waveforms),
                           matrix_of(Metric::oc, waveforms)};
    CHECK(matrix_of(Metric::no_physiology, waveforms) == rank_average(parts));
    for (const GoldenSet& set : golden_sets()) {
        if (!set.json.contains("no-physiology")) continue;
        // OC of the golden file: at full length it takes seconds.
        const Dissimilarity oc{set.waveforms.size(), set.json.at("oc")};
        const std::array known{matrix_of(Metric::msm, set.waveforms),
                               matrix_of(Metric::mtm, set.waveforms), oc};
        CHECK(worst(rank_average(known), set.json.at("no-physiology")) <= 1e-15);
    }
}

TEST_CASE(
    "metric matrix: NC and OC are the parts of PM, in all bits, whatever the model's choices") {
    const auto waveforms = short_set();
    PerceptualModelParams params;
    CHECK(params.envelope.waiting_cost == 0.0);
    const auto free = predict(waveforms, params);
    params.envelope.waiting_cost = 0.3;
    for (const EnvelopeScale scale : {EnvelopeScale::normalised, EnvelopeScale::raw}) {
        params.envelope.scale = scale;
        const auto prediction = predict(waveforms, params);
        REQUIRE(prediction);
        CHECK(prediction->oc != free->oc);
        CHECK(metric_matrix(Metric::oc, waveforms, params) == prediction->oc);
        CHECK(metric_matrix(Metric::nc, waveforms, params) == prediction->nc);
        CHECK(metric_matrix(Metric::pm, waveforms, params) == prediction->pm);
        const std::array known{*metric_matrix(Metric::msm, waveforms, params),
                               *metric_matrix(Metric::mtm, waveforms, params), prediction->oc};
        CHECK(metric_matrix(Metric::no_physiology, waveforms, params) == rank_average(known));
    }
}

TEST_CASE("metric matrix: zeros at the end of the shorter ones change no bit, but of DTW") {
    std::vector<Waveform> own = short_set();
    own.push_back(golden::noise(6, 1450, 0.2));  // one block of 64 ms and a part
    std::vector<Waveform> whole = own;
    for (Waveform& one : whole) one = padded(std::move(one), 1450);
    PerceptualModelParams params;
    for (const double waiting_cost : {0.0, 0.1}) {
        params.envelope.waiting_cost = waiting_cost;
        for (const Metric metric : kMetrics) {
            CAPTURE(std::string(traits(metric).key));
            const bool is_same =
                metric_matrix(metric, own, params) == metric_matrix(metric, whole, params);
            CHECK(is_same == (metric != Metric::dtw));
        }
    }
}

TEST_CASE("metric matrix: stopped, there is none; else progress ends at all of it") {
    const auto waveforms = short_set();
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        std::stop_source stop;
        MetricOptions options;
        options.stop = stop.get_token();
        options.threads = 1;
        double last = 0.0;
        options.progress = [&last](double share) { last = share; };
        CHECK(metric_matrix(metric, waveforms, {}, options));
        if (metric != Metric::nc) CHECK(last == 1.0);
        stop.request_stop();
        CHECK_FALSE(metric_matrix(metric, waveforms, {}, options));
    }
}

TEST_CASE("metric matrix: none and one pattern have no pairs") {
    const std::vector<Waveform> one{render(Pattern{})};
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        CHECK(matrix_of(metric, {}).condensed.empty());
        CHECK(matrix_of(metric, one) == Dissimilarity{1, {}});
    }
}

// Mid-ranks of the values, by counting.
std::vector<double> plain_ranks(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        const auto below = std::ranges::count_if(values, [&](double v) { return v < value; });
        const auto equal = std::ranges::count(values, value);
        ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal + 1));
    }
    return ranks;
}

TEST_CASE("metric matrix: as it is written, anybody's ranks of it are the ones that are compared") {
    std::vector<Waveform> waveforms;
    for (int k = 0; k < 8; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.2;
        pattern.amplitude_g = k % 2 == 0 ? 1.0 : 0.7;
        pattern.carriers[0].frequency_hz = 100.0 + 50.0 * (k / 4);
        pattern.modulation.frequency_hz = 5.0 * (k % 4);
        waveforms.push_back(render(pattern));
    }
    for (const Metric metric : kMetrics) {
        CAPTURE(std::string(traits(metric).key));
        const auto matrix = metric_matrix(metric, waveforms, {});
        REQUIRE(matrix);
        const Dissimilarity written = as_ranked(metric, *matrix);
        CHECK(plain_ranks(written.condensed) == average_ranks(values_to_rank(metric, *matrix)));
        for (std::size_t k = 0; k < written.condensed.size(); ++k) {
            CHECK(std::abs(written.condensed[k] - matrix->condensed[k]) <=
                  1e-8 * std::max(1.0, std::abs(matrix->condensed[k])));
        }
    }
}

}  // namespace metric_matrix_test
