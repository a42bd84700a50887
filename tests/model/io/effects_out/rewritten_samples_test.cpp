// Real files (tests/golden/effects), read, written in their own format and read again.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "tests/support/places.h"

namespace rewritten_samples_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

struct Sample {
    std::string name;
    EffectsRead read;
};

// All samples that are read, in one of the formats that are written.
std::vector<Sample> samples_of(const EffectFormat* format) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(kGoldenDir) / "effects")) {
        if (is_effect_name(entry.path().string())) paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<Sample> samples;
    for (const fs::path& path : paths) {
        std::ifstream stream(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        auto read = read_effects(text, path.string());
        if (read && read->format == format) {
            samples.push_back({path.filename().string(), *std::move(read)});
        }
    }
    return samples;
}

Pattern again(TargetFormat format, const Effect& effect, const ActuatorMap& map,
              std::vector<std::string>& remarks) {
    const WrittenEffect written = write_effect(format, effect.pattern, {effect.name, map});
    remarks = written.remarks;
    const auto read = read_effects(written.text, "again.x", map);
    REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
    REQUIRE(read->effects.size() == 1);
    return read->effects.front().pattern;
}

double largest_gap_g(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.001) {
        largest = std::max(largest, std::abs(envelope_g(a, t_s) - envelope_g(b, t_s)));
    }
    return largest;
}

double largest_gap_hz(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.001) {
        if (!(envelope_g(a, t_s) > 1e-6)) continue;
        largest = std::max(largest, std::abs(first_carrier_hz(a, t_s) - first_carrier_hz(b, t_s)));
    }
    return largest;
}

double largest_gap_of_transients_g(const Pattern& a, const Pattern& b) {
    REQUIRE(a.transients.size() == b.transients.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < a.transients.size(); ++k) {
        const Transient& one = a.transients[k];
        const Transient& other = b.transients[k];
        CHECK(std::abs(one.time_s - other.time_s) < 1e-4);
        CHECK(std::abs(one.frequency_hz - other.frequency_hz) < 0.01);
        largest = std::max(largest, std::abs(one.amplitude_g - other.amplitude_g));
    }
    return largest;
}

}  // namespace

TEST_CASE("rewritten samples: the four of HJIF are the same vibrations") {
    const auto samples = samples_of(format_named("hjif"));
    REQUIRE(samples.size() == 4);
    for (const Sample& sample : samples) {
        CAPTURE(sample.name);
        for (const Effect& effect : sample.read.effects) {
            std::vector<std::string> remarks;
            const Pattern back = again(TargetFormat::hjif, effect, sample.read.map, remarks);
            CAPTURE((remarks.empty() ? "" : remarks.front()));
            CHECK(back.duration_s == doctest::Approx(effect.pattern.duration_s));
            CHECK(largest_gap_g(effect.pattern, back) < 1e-4);
            CHECK(largest_gap_hz(effect.pattern, back) < 0.51);
            CHECK(largest_gap_of_transients_g(effect.pattern, back) < 1e-4);
        }
    }
}

TEST_CASE("rewritten samples: those of .haptic differ by what the remarks say alone") {
    const auto samples = samples_of(format_named("haptic"));
    REQUIRE(samples.size() >= 8);
    for (const Sample& sample : samples) {
        CAPTURE(sample.name);
        for (const Effect& effect : sample.read.effects) {
            std::vector<std::string> remarks;
            const Pattern back = again(TargetFormat::haptic, effect, sample.read.map, remarks);
            if (!remarks.empty()) continue;
            CHECK(back.duration_s == doctest::Approx(effect.pattern.duration_s));
            CHECK(largest_gap_g(effect.pattern, back) < 1e-6);
            CHECK(largest_gap_hz(effect.pattern, back) < 1e-3);
            CHECK(largest_gap_of_transients_g(effect.pattern, back) < 1e-6);
        }
    }
}

}  // namespace rewritten_samples_test
