#include "model/physiology/nc_matrix.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/pattern/pattern.h"
#include "tests/support/random_code.h"

namespace nc_matrix_test {

using namespace tact;

namespace {

std::vector<NeuralCode> codes_of_patterns() {
    std::vector<NeuralCode> codes;
    for (const double modulation_hz : {0.0, 2.0, 5.0, 20.0, 80.0}) {
        Pattern pattern;
        pattern.modulation.frequency_hz = modulation_hz;
        codes.push_back(neural_code(render(pattern), {}));
    }
    return codes;
}

constexpr PerReceptor<double> kTrained{0.2, 0.7, 0.0, 0.5};

}  // namespace

TEST_CASE("nc matrix: packed spikes give the bits of the sample by sample form") {
    // Around words of 64 and registers of 512 samples, and a 1 s pattern.
    for (const std::size_t samples : {1UL, 63UL, 64UL, 65UL, 511UL, 512UL, 513UL, 10'000UL}) {
        CAPTURE(samples);
        const NeuralCode a = random_code(samples, 1);
        const NeuralCode b = random_code(samples, 2);
        const PackedSpikes packed_a = packed_spikes(a);
        const PackedSpikes packed_b = packed_spikes(b);
        CHECK(spike_form(packed_a, packed_b) == spike_form(a, b));
        for (const auto& weight : {kTrained, PerReceptor<double>{0.1, 1.0 / 3.0, 0.77, 1000.0}}) {
            CHECK(nc_dissimilarity(packed_a, packed_b, weight) == nc_dissimilarity(a, b, weight));
        }
    }
    const auto codes = codes_of_patterns();
    for (const NeuralCode& a : codes) {
        for (const NeuralCode& b : codes) {
            CHECK(nc_dissimilarity(packed_spikes(a), packed_spikes(b), kTrained) ==
                  nc_dissimilarity(a, b, kTrained));
        }
    }
}

TEST_CASE("nc matrix: every instruction set counts alike") {
    const PackedSpikes a = packed_spikes(random_code(9999, 3));
    const PackedSpikes b = packed_spikes(random_code(9999, 4));
    const auto counters = coincidence_counters();
    REQUIRE(std::string(counters.back().name) == "baseline");
    const SpikeForm expected =
        counters.back().count({a.bits.data(), a.words}, {b.bits.data(), b.words});
    CHECK(expected[0][3] > 400);  // a sixteenth of the samples
    for (const CoincidenceCounter& counter : counters) {
        CAPTURE(counter.name);
        CHECK(counter.count({a.bits.data(), a.words}, {b.bits.data(), b.words}) == expected);
    }
}

TEST_CASE("nc matrix: from a to b is as far as from b to a, and to itself there is no way") {
    const NeuralCode a = random_code(5000, 5);
    const NeuralCode b = random_code(5000, 6);
    CHECK(nc_dissimilarity(a, b, kTrained) == nc_dissimilarity(b, a, kTrained));
    CHECK(nc_dissimilarity(a, b, kTrained) > 0.1);
    CHECK(nc_dissimilarity(a, a, kTrained) == 0.0);
    CHECK(nc_dissimilarity(packed_spikes(a), packed_spikes(a), kTrained) == 0.0);
}

TEST_CASE("nc matrix: one spike of one channel weighs its weight") {
    NeuralCode silent;
    silent.samples = 100;
    silent.central_spikes.assign(100, 0);
    for (std::size_t channel = 0; channel < kReceptorCount; ++channel) {
        NeuralCode spike = silent;
        spike.central_spikes[70] = static_cast<std::uint8_t>(1U << channel);
        // sqrt(w^2 / 100)
        const double expected = kTrained[channel] / 10.0;
        CHECK(std::abs(nc_dissimilarity(spike, silent, kTrained) - expected) <= 1e-16);
    }
}

TEST_CASE("nc matrix: channels whose weights add up to another's cancel it without a rest") {
    // In doubles 0.1 + 0.2 is not 0.3.
    NeuralCode two;
    two.samples = 10'000;
    two.central_spikes.assign(10'000, 0);
    NeuralCode one = two;
    for (std::size_t n = 0; n < 10'000; n += 3) {
        two.central_spikes[n] = 0b0011;
        one.central_spikes[n] = 0b1000;
    }
    CHECK(nc_dissimilarity(two, one, {0.1, 0.2, 0.0, 0.3}) == 0.0);
    CHECK(nc_dissimilarity(packed_spikes(two), packed_spikes(one), {0.1, 0.2, 0.0, 0.3}) == 0.0);
    CHECK(nc_dissimilarity(two, one, {0.1, 0.2, 0.0, 0.3 + 1e-9}) > 0.0);
}

TEST_CASE("nc matrix: it is the root mean square of the difference of the brain waveforms") {
    const auto codes = codes_of_patterns();
    for (const auto& weight : {kTrained, PerReceptor<double>{0.1, 1.0 / 3.0, 0.77, 0.9}}) {
        const auto a = predicted_brain_waveform(codes[0], weight);
        const auto b = predicted_brain_waveform(codes[3], weight);
        double sum = 0.0;
        for (std::size_t n = 0; n < a.size(); ++n) sum += (a[n] - b[n]) * (a[n] - b[n]);
        const double direct = std::sqrt(sum / static_cast<double>(a.size()));
        // 10,000 additions leave 1e-13, as much as the thirteenth decimal of a weight.
        CHECK(std::abs(nc_dissimilarity(codes[0], codes[3], weight) - direct) <= 1e-12);
        CHECK(direct > 0.1);
    }
}

TEST_CASE("nc matrix: what is behind the last spikes needs not be kept") {
    NeuralCode brief = random_code(700, 7);
    NeuralCode longer = random_code(3000, 8);
    brief.samples = longer.samples = 60'000;
    const auto whole = [](NeuralCode code) {
        code.central_spikes.resize(code.samples, 0);
        return code;
    };
    const auto dropped = [&whole](const NeuralCode& code) {
        NeuralCode own = whole(code);
        drop_silent_end(own);
        CHECK(own.central_spikes.size() <= code.central_spikes.size());
        return own;
    };
    const double expected = nc_dissimilarity(whole(brief), whole(longer), kTrained);
    CHECK(expected > 0.0);
    CHECK(nc_dissimilarity(dropped(brief), dropped(longer), kTrained) == expected);
    for (const auto& [a, b] : {std::pair(brief, longer), std::pair(longer, brief)}) {
        const PackedSpikes own = packed_spikes(dropped(a));
        CHECK(own.words < packed_spikes(random_code(60'000, 9)).words);
        CHECK(nc_dissimilarity(own, packed_spikes(whole(b)), kTrained) == expected);
        CHECK(predicted_brain_waveform(dropped(a), kTrained) ==
              predicted_brain_waveform(whole(a), kTrained));
    }
    const auto units = weight_units(kTrained);
    REQUIRE(units);
    CHECK(nc_dissimilarity(brain_units(dropped(brief), *units), brain_units(whole(longer), *units),
                           *units) == expected);
}

TEST_CASE("nc matrix: no samples are at no distance") {
    CHECK(nc_dissimilarity(packed_spikes({}), packed_spikes({}), kTrained) == 0.0);
}

}  // namespace nc_matrix_test
