#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/io/set/load.h"
#include "model/physiology/nc_matrix.h"
#include "model/physiology/neural_coding.h"
#include "model/set/pattern_set.h"
#include "tests/support/places.h"

namespace quick_code_test {

using namespace tact;

namespace {

constexpr PerReceptor<double> kTrained{0.2, 0.7, 0.0, 0.5};
constexpr std::size_t kMinute = 600'000;  // samples

// In a minute of silence most of them are too weak to be felt: times a gain, they are not.
std::vector<Waveform> bundled_patterns(double gain) {
    std::vector<Waveform> waveforms;
    for (const char* name : {"pm_2023_twelve", "rhythms_tactspace"}) {
        const auto loaded = load_set(std::string(kAssetsDir) + "/sets/" + name + ".tactspace.json");
        REQUIRE(loaded);
        for (const Vibration& one : loaded->set.vibrations) {
            waveforms.push_back(waveform_of(one));
            for (double& sample_g : waveforms.back().samples_g) sample_g *= gain;
        }
    }
    return waveforms;
}

// A type that hardly answers does so to few components: which, a coarser spectrum sees less well.
bool is_near(double value, double expected, double least) {
    return std::abs(value - expected) <= 0.1 * std::abs(expected) + least;
}

}  // namespace

TEST_CASE("quick code: in a set with a clip of a minute, receptors answer as they do exactly" *
          doctest::test_suite("long")) {
    NeuralCodingParams params;
    SUBCASE("all components") {}
    SUBCASE("raw samples") { params.remove_mean = false; }
    for (const Waveform& own : bundled_patterns(20.0)) {
        REQUIRE(can_be_quick(own, kMinute));
        const NeuralCode quick = quick_neural_code(own, kMinute, params);
        const NeuralCode exact = neural_code(padded(own, kMinute), params);
        CHECK(quick.samples == exact.samples);
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            CAPTURE(c);
            CAPTURE(exact.activation[c].rate_hz);
            CAPTURE(quick.activation[c].rate_hz);
            CAPTURE(exact.activation[c].radius_mm);
            CAPTURE(quick.activation[c].radius_mm);
            CHECK(is_near(quick.activation[c].rate_hz, exact.activation[c].rate_hz, 5.0));
            if (exact.activation[c].rate_hz < 5.0) continue;
            CHECK(is_near(quick.activation[c].radius_mm, exact.activation[c].radius_mm, 0.1));
        }
    }
}

TEST_CASE("quick code: few orders of pairs change by it" * doctest::test_suite("long")) {
    double gain = 1.0;
    SUBCASE("as they are") {}
    SUBCASE("strong") { gain = 5.0; }
    SUBCASE("very strong") { gain = 20.0; }
    std::vector<NeuralCode> quick;
    std::vector<NeuralCode> exact;
    for (const Waveform& own : bundled_patterns(gain)) {
        quick.push_back(quick_neural_code(own, kMinute, {}));
        exact.push_back(neural_code(padded(own, kMinute), {}));
    }
    std::vector<double> a;
    std::vector<double> b;
    for (std::size_t i = 0; i < quick.size(); ++i) {
        for (std::size_t j = i + 1; j < quick.size(); ++j) {
            a.push_back(nc_dissimilarity(exact[i], exact[j], kTrained));
            b.push_back(nc_dissimilarity(quick[i], quick[j], kTrained));
        }
    }
    int pairs = 0;
    int flips = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = i + 1; j < a.size(); ++j) {
            if (a[i] == a[j]) continue;
            ++pairs;
            if ((a[i] < a[j]) != (b[i] < b[j])) ++flips;
        }
    }
    CAPTURE(100.0 * flips / pairs);
    CHECK(100 * flips <= 2 * pairs);  // as app/map/live_map.cpp says
}

TEST_CASE("quick code: what is not short among long ones is coded exactly") {
    Pattern pattern;
    const Waveform own = render(pattern);
    const std::size_t samples = 3 * own.samples_g.size();
    REQUIRE_FALSE(can_be_quick(own, samples));
    const NeuralCode exact = neural_code(padded(own, samples), {});
    CHECK(quick_neural_code(own, samples, {}).central_spikes == exact.central_spikes);
}

}  // namespace quick_code_test
