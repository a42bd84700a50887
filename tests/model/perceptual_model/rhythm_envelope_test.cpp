#include "model/perceptual_model/rhythm_envelope.h"

#include <cmath>

#include "tests/support/golden.h"

namespace rhythm_envelope_test {

using namespace tact;

TEST_CASE("envelope: silence stays silent, constants become one after 10 ms") {
    const std::vector<double> silence(300, 0.0);
    CHECK(rhythm_envelope(silence, {}) == silence);
    const auto constant = rhythm_envelope(std::vector<double>(300, -2.0), {});
    CHECK(constant[0] == 0.01);
    CHECK(constant[98] < 1.0);
    CHECK(constant[99] == 1.0);
    CHECK(constant[299] == 1.0);
}

TEST_CASE("envelope: amplitude twins are the same, unless taken raw") {
    const auto quiet = golden::noise(1, 2000, 0.5).samples_g;
    const auto loud = golden::noise(1, 2000, 1.0).samples_g;  // exactly twice
    CHECK(rhythm_envelope(quiet, {}) == rhythm_envelope(loud, {}));
    EnvelopeParams raw;
    raw.scale = EnvelopeScale::raw;
    CHECK(rhythm_envelope(quiet, raw) != rhythm_envelope(loud, raw));
}

TEST_CASE("envelope: a centred window answers 5 ms earlier than a causal one") {
    std::vector<double> click(400, 0.0);
    click[200] = 1.0;
    EnvelopeParams centred;
    centred.alignment = EnvelopeAlignment::centred;
    const auto causal_envelope = rhythm_envelope(click, {});
    const auto centred_envelope = rhythm_envelope(click, centred);
    CHECK(causal_envelope[199] == 0.0);
    CHECK(causal_envelope[200] > 0.0);
    CHECK(centred_envelope[149] == 0.0);
    CHECK(centred_envelope[150] > 0.0);
    CHECK(centred_envelope[250] == 0.0);
}

TEST_CASE("envelope: decimation keeps the mean, also of the last short block") {
    CHECK(decimated(std::vector<double>{1, 3, 5, 7, 10}, 2) == std::vector<double>{2, 6, 10});
    CHECK(decimated({}, 10).empty());
}

TEST_CASE("envelope: a centred window reaches from 49 samples back to 50 ahead") {
    std::vector<double> click(400, 0.0);
    click[200] = 1.0;
    EnvelopeParams centred;
    centred.alignment = EnvelopeAlignment::centred;
    const auto envelope = rhythm_envelope(click, centred);
    for (std::size_t k = 0; k < envelope.size(); ++k) {
        CHECK((envelope[k] > 0.0) == (k + 50 >= 200 && k <= 200 + 49));
    }
    // Past the ends lie zeros: half the window, half the mean.
    const auto constant = rhythm_envelope(std::vector<double>(300, 1.0), centred);
    CHECK(constant[0] == 0.51);
    CHECK(constant[299] == 0.5);
}

// As the convolution is written, one window after the other.
std::vector<double> textbook(const std::vector<double>& samples, std::size_t ahead) {
    std::vector<double> envelope;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        double sum = 0.0;
        for (std::size_t m = 0; m < kEnvelopeSamples; ++m) {
            const std::size_t place = k + ahead + 1 + m;  // of the sample, 100 later
            if (place < kEnvelopeSamples || place - kEnvelopeSamples >= samples.size()) continue;
            sum += std::abs(samples[place - kEnvelopeSamples]);
        }
        envelope.push_back(sum / static_cast<double>(kEnvelopeSamples));
    }
    return envelope;
}

TEST_CASE("envelope: of a short pattern in a long set, what sounds is all that is kept") {
    EnvelopeParams centred;
    centred.alignment = EnvelopeAlignment::centred;
    for (const EnvelopeParams& params : {EnvelopeParams{}, centred}) {
        for (const std::size_t own : {0UL, 1UL, 60UL, 250UL}) {
            std::vector<double> samples(own, 0.0);
            for (std::size_t k = 0; k < own; ++k)
                samples[k] = 0.1 * static_cast<double>(k % 7) - 0.2;
            for (const std::size_t whole : {own, own + 3, own + 99, own + 100, own + 5000}) {
                std::vector<double> padded = samples;
                padded.resize(whole, 0.0);
                std::vector<double> expected = rhythm_envelope(padded, params);
                std::vector<double> envelope = own_rhythm_envelope(samples, whole, params);
                CHECK(envelope.size() <= own + kEnvelopeSamples);
                if (!envelope.empty()) CHECK(envelope.back() != 0.0);
                for (const std::size_t factor : {1UL, 10UL, 64UL}) {
                    auto coarse = decimated(envelope, factor, whole);
                    coarse.resize((whole + factor - 1) / factor, 0.0);
                    CHECK(coarse == decimated(expected, factor));
                }
                envelope.resize(whole, 0.0);
                CHECK(envelope == expected);
            }
        }
    }
}

TEST_CASE("envelope: windows side by side have the bits of one after the other") {
    for (const std::size_t sounding : {0UL, 1UL, 15UL, 16UL, 99UL, 100UL, 257UL, 1000UL}) {
        for (const std::size_t silent : {0UL, 1UL, 49UL, 99UL, 130UL, 1000UL}) {
            CAPTURE(sounding);
            CAPTURE(silent);
            auto samples =
                golden::noise(static_cast<std::uint32_t>(sounding + 1), sounding, 0.7).samples_g;
            samples.resize(sounding + silent, 0.0);
            EnvelopeParams params;
            params.scale = EnvelopeScale::raw;
            params.alignment = EnvelopeAlignment::causal;
            CHECK(rhythm_envelope(samples, params) == textbook(samples, 0));
            params.alignment = EnvelopeAlignment::centred;
            CHECK(rhythm_envelope(samples, params) == textbook(samples, 50));
        }
    }
    const auto sizes = golden::noise(9, 1024 + kEnvelopeSamples, 1.0).samples_g;
    std::vector<double> expected(1024);
    window_summers().back().sum(sizes.data(), expected);
    for (const WindowSummer& summer : window_summers()) {
        CAPTURE(summer.name);
        std::vector<double> sums(1024);
        summer.sum(sizes.data(), sums);
        CHECK(sums == expected);
    }
}

}  // namespace rhythm_envelope_test
