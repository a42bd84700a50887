#include "model/signal/butterworth.h"

#include "model/common/units.h"
#include "tests/support/golden.h"

namespace butterworth_test {

using namespace tact;
using golden::Json;

namespace {

std::vector<Section> sections_of(const Json& filter) {
    const Json& edges = filter.at("edges_hz");
    return edges[0].is_null() ? low_pass(10, edges[1], kModelRateHz)
                              : band_pass(5, edges[0], edges[1], kModelRateHz);
}

}  // namespace

TEST_CASE("butterworth: impulse responses and gains equal SciPy's") {
    const Json filters = golden::read("filters.json").at("filters");
    REQUIRE(filters.size() == 4);
    for (const auto& [name, filter] : filters.items()) {
        CAPTURE(name);
        const auto sections = sections_of(filter);
        std::vector<double> impulse(10'000, 0.0);
        impulse[0] = 1.0;
        const auto response = filtered(sections, impulse);
        const double scale = filter.at("impulse_max_abs");
        const std::vector<double> first = filter.at("impulse_first_200");
        for (std::size_t n = 0; n < first.size(); ++n) {
            CHECK(std::abs(response[n] - first[n]) <= 1e-9 * scale);
        }
        const std::vector<double> sparse = filter.at("impulse_every_500th");
        for (std::size_t k = 0; k < sparse.size(); ++k) {
            CHECK(std::abs(response[500 * k] - sparse[k]) <= 1e-9 * scale);
        }
        for (const Json& point : filter.at("gains")) {
            const double expected = point.at("gain");
            CHECK(std::abs(gain(sections, point.at("f_hz"), kModelRateHz) - expected) <= 1e-9);
        }
    }
}

TEST_CASE("butterworth: a filter is linear") {
    const auto sections = band_pass(5, 10.0, 500.0, kModelRateHz);
    const auto a = golden::noise(1, 2000, 1.0).samples_g;
    const auto b = golden::noise(2, 2000, 1.0).samples_g;
    std::vector<double> mixed(a.size());
    for (std::size_t n = 0; n < a.size(); ++n) mixed[n] = 3.0 * a[n] - 0.5 * b[n];
    const auto from_a = filtered(sections, a);
    const auto from_b = filtered(sections, b);
    const auto from_mixed = filtered(sections, mixed);
    for (std::size_t n = 0; n < a.size(); ++n) {
        CHECK(std::abs(from_mixed[n] - (3.0 * from_a[n] - 0.5 * from_b[n])) <= 1e-12);
    }
}

TEST_CASE("butterworth: half the power passes at the edges, all of it in the middle") {
    const auto band = band_pass(5, 15.0, 400.0, kModelRateHz);
    CHECK(std::abs(gain(band, 15.0, kModelRateHz) - std::sqrt(0.5)) <= 1e-9);
    CHECK(std::abs(gain(band, 400.0, kModelRateHz) - std::sqrt(0.5)) <= 1e-9);
    CHECK(std::abs(gain(band, 77.5, kModelRateHz) - 1.0) <= 1e-4);
    const auto low = low_pass(10, 5.0, kModelRateHz);
    CHECK(std::abs(gain(low, 5.0, kModelRateHz) - std::sqrt(0.5)) <= 1e-9);
}

TEST_CASE("butterworth: an order-10 low-pass falls 60 dB per octave") {
    const auto low = low_pass(10, 5.0, kModelRateHz);
    const double octave = gain(low, 80.0, kModelRateHz) / gain(low, 40.0, kModelRateHz);
    // Asymptote 2^-10; the bilinear transform bends it by less than 1 % this far below Nyquist.
    CHECK(std::abs(octave * 1024.0 - 1.0) <= 0.01);
}

TEST_CASE("butterworth: odd orders have their real pole") {
    const auto low = low_pass(1, 100.0, kModelRateHz);
    CHECK(low.size() == 1);
    CHECK(std::abs(gain(low, 100.0, kModelRateHz) - std::sqrt(0.5)) <= 1e-12);
    CHECK(low_pass(3, 100.0, kModelRateHz).size() == 2);
}

}  // namespace butterworth_test
