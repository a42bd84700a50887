#include "model/signal/spectrum.h"

#include <complex>
#include <numbers>
#include <thread>

#include "model/signal/waveform.h"
#include "tests/support/golden.h"

namespace spectrum_test {

using namespace tact;

TEST_CASE("spectrum: a sine on a bin gives its amplitude there and nothing elsewhere") {
    const Spectrum spectrum = amplitude_spectrum(render(Pattern{}).samples_g, kModelRateHz);
    CHECK(frequency_hz(spectrum, 150) == 150.0);
    CHECK(std::abs(spectrum.amplitude_g[150] - 1.0) <= 1e-12);
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        if (k != 150) CHECK(spectrum.amplitude_g[k] <= 1e-12);
    }
}

TEST_CASE("spectrum: energy is kept (Parseval), for even, odd and prime lengths") {
    for (const std::size_t n : {1000UL, 1001UL, 997UL, 2UL, 1UL}) {
        const auto samples = golden::noise(9, n, 1.0).samples_g;
        const Spectrum spectrum = amplitude_spectrum(samples, kModelRateHz);
        double in_time = 0.0;
        for (const double sample : samples) in_time += sample * sample / static_cast<double>(n);
        double in_frequency = 0.0;
        for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
            const double power = spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
            in_frequency += k == 0 || 2 * k == n ? power : power / 2.0;
        }
        CHECK(std::abs(in_time - in_frequency) <= 1e-12);
    }
}

TEST_CASE("spectrum: nothing has no spectrum") {
    CHECK(amplitude_spectrum({}, kModelRateHz).amplitude_g.empty());
}

TEST_CASE("spectrum: the same bits from several threads at once") {
    const auto samples = golden::noise(11, 3000, 1.0).samples_g;
    const auto expected = amplitude_spectrum(samples, kModelRateHz).amplitude_g;
    std::vector<std::vector<double>> results(4);
    {
        std::vector<std::jthread> threads;
        for (auto& result : results) {
            threads.emplace_back([&result, &samples] {
                result = amplitude_spectrum(samples, kModelRateHz).amplitude_g;
            });
        }
    }
    for (const auto& result : results) CHECK(result == expected);
}

TEST_CASE("spectrum: the same bits whatever lengths others ask for before and meanwhile") {
    const std::size_t lengths[] = {1000, 997, 2500, 1000};
    std::vector<std::vector<std::complex<double>>> alone;
    for (const std::size_t n : lengths) {
        alone.push_back(half_spectrum(golden::noise(9, n, 1.0).samples_g));
    }
    CHECK(alone[0] == alone[3]);
    bool same[4] = {true, true, true, true};
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < 4; ++k) {
        threads.emplace_back([&, k] {
            const auto samples = golden::noise(9, lengths[k], 1.0).samples_g;
            const auto back = samples_of(alone[k], lengths[k]);
            for (int turn = 0; turn < 200; ++turn) {
                same[k] = same[k] && half_spectrum(samples) == alone[k];
                same[k] = same[k] && samples_of(alone[k], lengths[k]) == back;
            }
        });
    }
    // More than the plans that are kept at a time.
    for (const std::size_t n : {1U << 18U, 5U << 16U, 3U << 17U, 7U << 16U, 1U << 19U}) {
        half_spectrum(std::vector<double>(n, 1.0));
    }
    threads.clear();
    for (const bool one : same) CHECK(one);
    CHECK(half_spectrum(golden::noise(9, lengths[2], 1.0).samples_g) == alone[2]);
}

TEST_CASE("spectrum: a filter without delay takes what its gain says, where it was") {
    const std::vector<double> samples = golden::noise(5, 1000, 1.0).samples_g;
    const auto same = zero_phase_filtered(samples, kModelRateHz, [](double) { return 1.0; });
    CHECK(golden::worst_difference(same, samples) <= 1e-12);
    const auto half = zero_phase_filtered(samples, kModelRateHz, [](double) { return 0.5; });
    for (std::size_t n = 0; n < samples.size(); ++n) {
        CHECK(std::abs(half[n] - samples[n] / 2.0) <= 1e-12);
    }
    // Only the tone below 100 Hz stays: in place, and in the middle to its height.
    std::vector<double> low(2000);
    std::vector<double> both(2000);
    for (std::size_t n = 0; n < low.size(); ++n) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(n) / kModelRateHz;
        low[n] = std::sin(50.0 * turn);
        both[n] = low[n] + std::sin(200.0 * turn);
    }
    const auto kept = zero_phase_filtered(both, kModelRateHz,
                                          [](double f_hz) { return f_hz < 100.0 ? 1.0 : 0.0; });
    REQUIRE(kept.size() == both.size());
    for (std::size_t n = 500; n < 1500; ++n) CHECK(std::abs(kept[n] - low[n]) <= 0.05);
}

TEST_CASE("spectrum: nothing of a filter's ringing comes round from the other end") {
    std::vector<double> samples(400, 0.0);
    samples.back() = 1.0;
    const auto smooth = zero_phase_filtered(samples, kModelRateHz, [](double f_hz) {
        return 1.0 / (1.0 + (f_hz / 1000.0) * (f_hz / 1000.0));  // rings for 0.2 ms
    });
    CHECK(smooth.back() > 0.1);
    CHECK(std::abs(smooth.front()) <= 1e-4);
    CHECK(zero_phase_filtered({}, kModelRateHz, [](double) { return 1.0; }).empty());
}

TEST_CASE("spectrum: half a spectrum gives its samples back") {
    for (const std::size_t count : {1U, 2U, 37U, 64U}) {
        const std::vector<double> samples = golden::noise(9, count, 1.0).samples_g;
        CHECK(golden::worst_difference(samples_of(half_spectrum(samples), count), samples) < 1e-14);
    }
    CHECK(half_spectrum({}).empty());
    CHECK(samples_of({}, 0).empty());
}

}  // namespace spectrum_test
