// Files of other programs (tests/golden/effects, with their licences), one by one.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "model/io/effects/actuator_file.h"
#include "model/io/formats/read_effects.h"
#include "model/pattern/drawn_fault.h"
#include "tests/support/mutations.h"
#include "tests/support/places.h"

namespace effect_samples_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    REQUIRE_MESSAGE(stream.good(), path.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

fs::path samples() { return fs::path(kGoldenDir) / "effects"; }

// What is refused, and the end of its sentence; all others are read.
const std::map<std::string, std::string> kRefused{
    {"invalid_empty_amplitude_envelope.haptic",
     "/signals/continuous/envelopes/amplitude: expected an array of 2 to 100000, got an array of "
     "0"},
    {"invalid_freq_bp_outside_amp_env.haptic",
     "/signals/continuous/envelopes/frequency/2/time: expected a time within the amplitude "
     "envelope, got 1.0001"},
    {"invalid_single_amplitude_breakpoint.haptic",
     "/signals/continuous/envelopes/amplitude: expected an array of 2 to 100000, got an array of "
     "1"},
    {"invalid_zero_duration.haptic",
     "/signals/continuous/envelopes/amplitude: expected a duration above 0, all points are at one "
     "time"},
    {"validation_v1_emphasis_amplitude.haptic",
     "/signals/continuous/envelopes/amplitude/2/emphasis/amplitude: expected at least the "
     "amplitude "
     "of its point, got 0.2"},
    {"validation_v1_sequence.haptic",
     "/signals/continuous/envelopes/amplitude/2/time: expected a time not before the last point's, "
     "got 0.1"},
    {"invalid.ahap",
     "/Pattern/1: expected \"Event\", \"ParameterCurve\" or \"Parameter\", got "
     "\"ParameterCurves\""}};

std::vector<fs::path> effect_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(samples())) {
        if (is_effect_name(entry.path().string())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

TEST_CASE("effect samples: every valid file is read, every other refused with its sentence") {
    const auto files = effect_files();
    CHECK(files.size() == 35);
    for (const fs::path& path : files) {
        const std::string name = path.filename().string();
        CAPTURE(name);
        const auto read = read_effects(text_of(path), name);
        const auto refused = kRefused.find(name);
        if (refused != kRefused.end()) {
            REQUIRE(!read);
            CHECK(read.error().message == name + ": " + refused->second);
            continue;
        }
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        REQUIRE(read->effects.size() == 1);
        const Pattern& pattern = read->effects.front().pattern;
        CHECK(read->effects.front().name == path.stem().string());
        CHECK(!drawn_fault(pattern));
        CHECK(is_drawn(pattern));
        CHECK(pattern == clamped(pattern));
        const bool silent = name.starts_with("2_points.") && name != "2_points.hjif";
        CHECK((peak_g(render(pattern)) > 0.0) != silent);
    }
}

TEST_CASE("effect samples: a clip and Meta's AHAP of it agree, but for what a device does") {
    // Meta writes the root of its amplitude and of its frequency: the square of intensity.
    ActuatorMap plain = bundled_actuator("quest");
    plain.ducking = 1.0;
    ActuatorMap squared = plain;
    squared.intensity_law = IntensityLaw::squared;
    const auto clip = read_effects(text_of(samples() / "haptic/16_points.haptic"), "a", plain);
    const auto ahap = read_effects(text_of(samples() / "ahap/16_points.ahap"), "b", squared);
    REQUIRE(clip);
    REQUIRE(ahap);
    const Pattern& a = clip->effects.front().pattern;
    const Pattern& b = ahap->effects.front().pattern;
    for (const AmplitudePoint& point : a.amplitude_curve) {
        CHECK(amplitude_factor(b, point.time_s) == doctest::Approx(point.value).epsilon(1e-4));
    }
}

TEST_CASE("effect samples: configurations of actuators are maps") {
    for (const char* name :
         {"MetaQuest", "Generic-Console-PCM", "Generic-Console-SimpleHaptics", "template"}) {
        const auto map = read_actuator_file(samples() / "acf" / (std::string(name) + ".acf"));
        REQUIRE_MESSAGE(map, (map ? "" : map.error().message));
        const auto again = parse_actuator(print_actuator(*map), "own.json");
        REQUIRE(again);
        CHECK(*again == *map);
    }
    const auto file = read_actuator_file(samples() / "acf/MetaQuest.acf");
    ActuatorMap bundled = bundled_actuator("quest");
    bundled.name = file->name;
    bundled.source = file->source;
    CHECK(*file == bundled);
}

TEST_CASE("effect samples: cut anywhere or damaged, a file gives a sentence or sound patterns") {
    std::mt19937 random(20261122);
    for (const fs::path& path : effect_files()) {
        const std::string whole = text_of(path);
        for (int round = 0; round < 60; ++round) {
            std::string text = whole;
            if (round % 3 == 0) {
                text.resize(any_below(random, text.size()));
            } else {
                text = after_mishaps(std::move(text), random);
            }
            CAPTURE(path.filename().string());
            CAPTURE(round);
            const auto read = read_effects(text, "damaged");
            if (!read) {
                CHECK(read.error().message.starts_with("damaged"));
                CHECK(read.error().message.find('\n') == std::string::npos);
                continue;
            }
            for (const Effect& effect : read->effects) {
                CHECK(!drawn_fault(effect.pattern));
                CHECK(effect.pattern == clamped(effect.pattern));
            }
        }
    }
}

}  // namespace effect_samples_test
