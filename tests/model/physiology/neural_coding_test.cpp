#include "model/physiology/neural_coding.h"

#include <numbers>
#include <numeric>

#include "model/perceptual_model/rhythm_envelope.h"
#include "tests/support/golden.h"

namespace neural_coding_test {

using namespace tact;
using golden::Json;

namespace {

// Real numbers agree to the rounding of two orders of floating-point operations; the order-10
// low-pass at 5 Hz leaves more (SciPy itself is off its long double self by 4e-10 there).
constexpr double kTolerance = 1e-9;
constexpr double kMerkelTolerance = 1e-8;

double sum_of_squares(const std::vector<double>& values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

void check_near(double got, double expected) {
    CHECK(std::abs(got - expected) <= kTolerance * std::max(1.0, std::abs(expected)));
}

// sum (k+1)(j+1) count mod 1000003 over receptors k and steps j.
long checksum(const std::vector<std::vector<int>>& counts) {
    long sum = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        for (std::size_t j = 0; j < counts[k].size(); ++j) {
            sum += static_cast<long>((k + 1) * (j + 1)) * counts[k][j] % 1000003;
            sum %= 1000003;
        }
    }
    return sum;
}

std::vector<int> totals(const std::vector<std::vector<int>>& counts) {
    std::vector<int> result;
    for (const auto& train : counts) {
        result.push_back(std::accumulate(train.begin(), train.end(), 0));
    }
    return result;
}

void check_layers(const ChannelStages& channel, const Json& expected) {
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const Json& layer = expected[k];
        std::vector<double> centre;
        double sum = 0.0;
        int at_cap = 0;
        for (const auto& step : channel.layers) {
            const RelayLayer& cells = step[k + 1];
            REQUIRE(2 * cells.half_width + 1 == layer.at("size").get<int>());
            centre.push_back(cells.centre());
            sum += std::accumulate(cells.cells.begin(), cells.cells.end(), 0.0);
            at_cap += static_cast<int>(std::ranges::count(cells.cells, 50.0));
        }
        CHECK(sum == layer.at("sum").get<double>());
        CHECK(at_cap == layer.at("at_cap").get<int>());
        CHECK(centre == layer.at("centre").get<std::vector<double>>());
    }
}

void check_channel(const NeuralCodingStages& stages, Receptor receptor, const Json& expected) {
    CAPTURE(traits(receptor).name);
    const ChannelStages& channel = stages.channel[index_of(receptor)];
    const Activation& activated = stages.code.activation[index_of(receptor)];
    check_near(activated.rate_hz, expected.at("f0_imp_per_s"));
    check_near(activated.slope_sum, expected.at("slope_sum"));
    check_near(activated.radius_mm, expected.at("r_max_mm"));
    CHECK(2 * channel.grid.half_width + 1 == expected.at("n0").get<int>());
    CHECK(channel.grid.receptors.size() == expected.at("receptors").get<std::size_t>());
    CHECK(channel.silent == expected.at("silent").get<bool>());
    const double tolerance = receptor == Receptor::merkel ? kMerkelTolerance : kTolerance;
    CHECK(golden::worst_difference(golden::every(97, channel.perceived),
                                   expected.at("perceived_every_97th")) <= tolerance);
    const double energy = expected.at("perceived_energy");
    CHECK(std::abs(sum_of_squares(channel.perceived) - energy) <= tolerance * energy);
    const auto centre = expected.at("centre_receptor").get<std::size_t>();
    CHECK(channel.spike_count[centre] ==
          expected.at("centre_receptor_counts").get<std::vector<int>>());
    CHECK(checksum(channel.spike_count) == expected.at("spikes_checksum").get<long>());
    if (expected.contains("receptor_totals")) {
        CHECK(totals(channel.spike_count) ==
              expected.at("receptor_totals").get<std::vector<int>>());
    }
    check_layers(channel, expected.at("layers"));
    CHECK(stages.code.central_count[index_of(receptor)] ==
          expected.at("final_counts").get<std::vector<int>>());
}

void check_components(const NeuralCodingStages& stages, const Json& expected) {
    std::vector<Component> loudest = stages.components;
    CHECK(loudest.size() == expected.at("components").get<std::size_t>());
    std::ranges::stable_sort(loudest, std::ranges::greater{}, &Component::amplitude_g);
    for (std::size_t k = 0; k < expected.at("largest").size(); ++k) {
        // Equal amplitudes of twins may stand in either order, so only amplitudes are compared.
        check_near(loudest[k].amplitude_g, expected.at("largest")[k].at("A_g"));
    }
}

}  // namespace

TEST_CASE("neural coding: every stage equals the independent program's" *
          doctest::test_suite("long")) {
    const Json stages_json = golden::read("stages.json");
    REQUIRE(stages_json.at("cases").size() > 40);
    for (const Json& expected : stages_json.at("cases")) {
        const std::string name = expected.at("name");
        CAPTURE(name);
        const Waveform waveform = golden::waveform_of_case(expected);
        const PerceptualModelParams params = golden::params_of(expected.at("params"));
        CHECK(golden::worst_difference(golden::every(97, waveform.samples_g),
                                       expected.at("input").at("every_97th_g")) <= kTolerance);
        const NeuralCodingStages stages = neural_coding_stages(waveform, params.coding);
        if (params.coding.components == Components::all) {
            check_components(stages, expected.at("spectrum"));
        }
        for (const Receptor receptor : kReceptors) {
            check_channel(stages, receptor, expected.at("channels").at(traits(receptor).afferent));
        }
        const auto pbw = predicted_brain_waveform(stages.code, params.channel_weight);
        const Json& expected_pbw = expected.at("pbw");
        REQUIRE(pbw.size() == expected_pbw.at("samples").get<std::size_t>());
        check_near(sum_of_squares(pbw), expected_pbw.at("sum_squares"));
        CHECK(golden::worst_difference(golden::every(53, pbw), expected_pbw.at("every_53rd")) <=
              kTolerance);
        const auto envelope = rhythm_envelope(waveform.samples_g, params.envelope);
        CHECK(golden::worst_difference(golden::every(97, envelope),
                                       expected.at("envelope").at("every_97th")) <= kTolerance);
    }
}

TEST_CASE("neural coding: the code alone is the same, to the bit, as with every stage kept") {
    for (const double amplitude_g : {0.05, 1.0, 8.0}) {
        for (const int inhibitory : {0, 1, 3}) {
            Pattern pattern;
            pattern.amplitude_g = amplitude_g;
            pattern.carriers = {{70.0, 0.5, 0.0}, {210.0, 0.5, 0.0}};
            pattern.modulation.frequency_hz = 4.0;
            NeuralCodingParams params;
            params.inhibitory_layers = inhibitory;
            params.inhibitory = {2.0, -0.25};  // arms that leave some activity
            const NeuralCode alone = neural_code(render(pattern), params);
            const NeuralCode whole = neural_coding_stages(render(pattern), params).code;
            CHECK(alone.central_count == whole.central_count);
            CHECK(alone.central_spikes == whole.central_spikes);
            CHECK(alone.activated == whole.activated);
        }
    }
}

TEST_CASE("neural coding: the layers made for one step are those kept with all") {
    Pattern pattern;
    pattern.amplitude_g = 2.0;
    pattern.modulation.frequency_hz = 4.0;
    const NeuralCodingParams params;
    const NeuralCodingStages kept = neural_coding_stages(render(pattern), params);
    const NeuralCodingStages lean = neural_coding_stages(render(pattern), params, KeepLayers::none);
    CHECK(lean.code.central_count == kept.code.central_count);
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        CHECK(lean.channel[c].layers.empty());
        CHECK(lean.channel[c].spike_count == kept.channel[c].spike_count);
        for (const std::size_t step : {0, 17, 60, 199}) {
            const auto layers = relay_layers(lean.channel[c], step, params);
            REQUIRE(layers.size() == kept.channel[c].layers[step].size());
            for (std::size_t k = 0; k < layers.size(); ++k) {
                CHECK(layers[k].cells == kept.channel[c].layers[step][k].cells);
            }
        }
    }
}

TEST_CASE("neural coding: silence in, silence out, and no distance between silences") {
    Waveform silence{kModelRateHz, std::vector<double>(1234, 0.0)};
    const NeuralCode code = neural_code(silence, {});
    CHECK(code.central_spikes.size() == 1300);
    CHECK(std::ranges::all_of(code.central_spikes, [](std::uint8_t mask) { return mask == 0; }));
    for (const Activation& activated : code.activation) CHECK(activated == Activation{});
    CHECK(nc_dissimilarity(code, code, {0.2, 0.7, 0.0, 0.5}) == 0.0);
}

TEST_CASE("neural coding: a constant offset is not felt") {
    Waveform tone = render(Pattern{});
    Waveform shifted = tone;
    for (double& sample : shifted.samples_g) sample += 0.25;
    const NeuralCode plain = neural_code(tone, {});
    CHECK(neural_code(shifted, {}).central_count == plain.central_count);
    NeuralCodingParams literal;
    literal.remove_mean = false;  // the onset step then reaches the receptors
    CHECK(neural_code(shifted, literal).central_count != plain.central_count);
}

TEST_CASE("neural coding: no samples give no code, not a crash") {
    const NeuralCode code = neural_code(Waveform{}, {});
    CHECK(code.central_spikes.empty());
    CHECK(nc_dissimilarity(code, code, {1, 1, 1, 1}) == 0.0);
}

TEST_CASE("neural coding: NC is the root mean square of the brain waveforms' difference") {
    Pattern slow;
    slow.modulation.frequency_hz = 5.0;
    const NeuralCode a = neural_code(render(Pattern{}), {});
    const NeuralCode b = neural_code(render(slow), {});
    const PerReceptor<double> weight{0.2, 0.7, 0.0, 0.5};
    const auto pbw_a = predicted_brain_waveform(a, weight);
    const auto pbw_b = predicted_brain_waveform(b, weight);
    double sum = 0.0;
    for (std::size_t n = 0; n < pbw_a.size(); ++n) {
        sum += (pbw_a[n] - pbw_b[n]) * (pbw_a[n] - pbw_b[n]);
    }
    const double direct = std::sqrt(sum / static_cast<double>(pbw_a.size()));
    // Another order of 10,000 additions: a few units in the last place each.
    CHECK(std::abs(nc_dissimilarity(a, b, weight) - direct) <= 1e-12);
}

TEST_CASE("neural coding: a stop in the middle of a long pattern ends it within a step") {
    Waveform minute{kModelRateHz, {}};
    for (std::size_t n = 0; n < 600'000; ++n) {
        const double t_s = static_cast<double>(n) / kModelRateHz;
        minute.samples_g.push_back(std::sin(2.0 * std::numbers::pi * 150.0 * t_s));
    }
    const std::size_t steps = kReceptorCount * step_count(minute.samples_g.size());
    for (const std::size_t last : {std::size_t{0}, std::size_t{1}, steps / 4 + 3}) {
        CAPTURE(last);
        std::stop_source stop;
        if (last == 0) stop.request_stop();
        std::size_t done = 0;
        CodingOptions options{
            stop.get_token(), [&](double share) {
                ++done;
                CHECK(share == static_cast<double>(done) / static_cast<double>(steps));
                if (done == last) stop.request_stop();
            }};
        const NeuralCodingStages stages =
            neural_coding_stages(minute, {}, KeepLayers::none, options);
        CHECK(done == last);
        // The trains of channels that were not reached yet are empty: of all channels, of three, or
        // of two.
        const std::size_t channels = last == 0 ? 0 : last == 1 ? 1 : 2;
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            CHECK(stages.channel[c].spike_count.empty() == (c >= channels));
        }
        CHECK(stages.code.central_spikes.size() == minute.samples_g.size());
    }
}

TEST_CASE("neural coding: watched or not, the bits are the same") {
    const Waveform waveform = render(Pattern{});
    const std::stop_source stop;
    double last = 0.0;
    const NeuralCode watched =
        neural_code(waveform, {}, {stop.get_token(), [&last](double share) { last = share; }});
    const NeuralCode alone = neural_code(waveform, {});
    CHECK(last == 1.0);
    CHECK(watched.central_spikes == alone.central_spikes);
    CHECK(watched.central_count == alone.central_count);
    CHECK(watched.activated == alone.activated);
    CHECK(watched.activation == alone.activation);
}

}  // namespace neural_coding_test
