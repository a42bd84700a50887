// Numbers from the design page's worked examples.
#include "model/metrics/perceptual_spectrum.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace perceptual_spectrum_test {

using namespace tact;

TEST_CASE("threshold curve: -15 dB at rest, -77 dB at 250 Hz, held above 0 dB from 782 Hz") {
    const auto curve = perceptual_threshold_db(512, 8000.0);
    CHECK(curve[0] == -15.0);
    const auto lowest = std::ranges::min_element(curve);
    const auto place = static_cast<double>(lowest - curve.begin());
    CHECK(std::abs(place * 8000.0 / 1023.0 - 250.0) <= 8000.0 / 1023.0);
    CHECK(*lowest >= -77.0);
    CHECK(*lowest <= -76.99);
    CHECK(curve[99] < 0.0);
    CHECK(std::abs(curve[100] - 0.26697) <= 5e-6);
    for (std::size_t k = 100; k < curve.size(); ++k) CHECK(curve[k] == curve[100]);
}

TEST_CASE("threshold curve: of four lines at 8 kHz three are held at the first above 0 dB") {
    const auto curve = perceptual_threshold_db(4, 8000.0);
    CHECK(curve[0] == -15.0);
    for (std::size_t k = 1; k < 4; ++k) CHECK(std::abs(curve[k] - 79.972040539534) <= 5e-13);
}

TEST_CASE("threshold curve: where it stays below 0 dB, nothing is held") {
    const auto curve = perceptual_threshold_db(512, 1000.0);  // up to 500 Hz
    CHECK(curve.back() < 0.0);
    CHECK(curve.back() != curve[curve.size() - 2]);
}

TEST_CASE("cosine transform: keeps energy, finds a cosine's line, and a constant's") {
    for (const std::size_t samples : {1UL, 4UL, 7UL, 512UL}) {
        const auto block = golden::noise(2, samples, 1.0).samples_g;
        double in_time = 0.0;
        double in_lines = 0.0;
        for (const double sample : block) in_time += sample * sample;
        for (const double line : cosine_transform(block)) in_lines += line * line;
        CHECK(std::abs(in_time - in_lines) <= 1e-13 * static_cast<double>(samples));
    }
    std::vector<double> cosine(64);
    for (std::size_t n = 0; n < 64; ++n) {
        const double angle = std::numbers::pi * 5.0 * (2.0 * static_cast<double>(n) + 1.0) / 128.0;
        cosine[n] = std::cos(angle);
    }
    const auto lines = cosine_transform(cosine);
    for (std::size_t k = 0; k < 64; ++k) {
        CHECK(std::abs(lines[k] - (k == 5 ? std::sqrt(32.0) : 0.0)) <= 1e-13);
    }
    CHECK(std::abs(cosine_transform(std::vector<double>(9, 2.0))[0] - 6.0) <= 1e-14);
}

TEST_CASE("blocks: the remainder is cut, and what is shorter than one is padded to it") {
    const auto count = [](std::size_t samples) {
        return perceptual_blocks(golden::noise(1, samples, 1.0)).count;
    };
    CHECK(count(0) == 1);
    CHECK(count(1) == 1);
    CHECK(count(1023) == 1);
    CHECK(count(1024) == 2);
    CHECK(count(10'000) == 19);
    const auto blocks = perceptual_blocks(golden::noise(1, 100, 1.0));
    REQUIRE(blocks.samples.size() == 512);
    CHECK(blocks.samples[99] != 0.0);
    for (std::size_t n = 100; n < 512; ++n) CHECK(blocks.samples[n] == 0.0);
}

TEST_CASE("blocks: silence is -infinity dB on every line, never NaN") {
    const auto blocks = perceptual_blocks(Waveform{kModelRateHz, std::vector<double>(600, 0.0)});
    for (const double level_db : blocks.level_db) CHECK(level_db == -INFINITY);
}

TEST_CASE("blocks: in m/s^2 every level is 19.83 dB higher") {
    PerceptualSpectrumParams metric;
    metric.unit = AmplitudeUnit::m_per_s2;
    const auto noise = golden::noise(4, 512, 1.0);
    const auto in_g = perceptual_blocks(noise).level_db;
    const auto in_metric = perceptual_blocks(noise, metric).level_db;
    for (std::size_t k = 0; k < in_g.size(); ++k) {
        CHECK(std::abs(in_metric[k] - in_g[k] - 20.0 * std::log10(9.80665)) <= 1e-9);
    }
}

TEST_CASE("blocks: brought to 8 kHz first, 1 s is 15 blocks and a tone stays at its line") {
    PerceptualSpectrumParams published;
    published.rate = ThresholdRate::resampled_to_it;
    const auto blocks = perceptual_blocks(tone(250.0, kModelRateHz, 10'000), published);
    CHECK(blocks.count == 15);
    // Line k is at 8000 k / 1024 Hz: 250 Hz is line 32.
    const auto middle = std::span(blocks.level_db).subspan(7 * 512, 512);
    CHECK(std::abs(std::ranges::max_element(middle) - middle.begin() - 32) <= 1);
}

}  // namespace perceptual_spectrum_test
