#include "assets/assets.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "tests/support/temporary_folder.h"

namespace assets_test {

using namespace tact;

namespace {

PatternSet example(const std::string& name) {
    const std::string path = "sets/" + name + ".tactspace.json";
    auto set = parse_set(asset(path), path, {});
    REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
    return *std::move(set);
}

const Pattern& pattern(const Vibration& vibration) { return std::get<Pattern>(vibration.source); }

}  // namespace

TEST_CASE("assets: every set is stored exactly as the program writes it") {
    int sets = 0;
    for (const Asset& file : assets()) {
        if (!file.path.ends_with(".tactspace.json")) continue;
        ++sets;
        CAPTURE(file.path);
        const auto set = parse_set(file.text, std::string(file.path), {});
        REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
        CHECK(print_set(*set) == file.text);
        CHECK(*parse_set(print_set(*set), "again", {}) == *set);
        CHECK(set->unknown_json.empty());
        for (const Vibration& vibration : set->vibrations) CHECK_FALSE(vibration.note.empty());
    }
    CHECK(sets == 13);
}

TEST_CASE("assets: the paper's twelve patterns are those of its section 6.1") {
    const PatternSet set = example("pm_2023_twelve");
    REQUIRE(set.vibrations.size() == 12);
    CHECK(set.name == "PM 2023, twelve patterns");
    CHECK(set.vibrations[0].name == "L-0-half");
    for (const Vibration& vibration : set.vibrations) {
        CAPTURE(vibration.name);
        const Pattern& p = pattern(vibration);
        Pattern expected;
        expected.amplitude_g = vibration.name.ends_with("half") ? 0.8 : 1.6;
        if (contains(vibration.name, "-4-")) expected.modulation.frequency_hz = 4.0;
        if (vibration.name.starts_with("L-")) expected.carriers = {{70.0, 1.0, 0.0}};
        if (vibration.name.starts_with("H-")) expected.carriers = {{210.0, 1.0, 0.0}};
        if (vibration.name.starts_with("LH-")) {
            expected.carriers = {{70.0, 0.5, 0.0}, {210.0, 0.5, 0.0}};
        }
        CHECK(p == expected);
    }
}

TEST_CASE("assets: the eight AM patterns come in both readings") {
    for (const double fourth_hz : {4.0, 5.0}) {
        const PatternSet set =
            example(fourth_hz == 4.0 ? "park_choi_2011_am_4hz" : "park_choi_2011_am_5hz");
        std::vector<double> modulation_hz;
        for (const Vibration& vibration : set.vibrations) {
            Pattern plain = pattern(vibration);
            modulation_hz.push_back(plain.modulation.frequency_hz);
            plain.modulation.frequency_hz = 0.0;
            CHECK(plain == Pattern{});
        }
        CHECK(modulation_hz == std::vector<double>{0, 1, 2, fourth_hz, 10, 20, 40, 80});
    }
}

TEST_CASE("assets: our own rhythms say so, and differ") {
    const PatternSet set = example("rhythms_tactspace");
    CHECK(set.name == "tactspace rhythms (our own, not from a study)");
    REQUIRE(set.vibrations.size() == 12);
    for (std::size_t i = 0; i < 12; ++i) {
        CHECK(pattern(set.vibrations[i]).rhythm.text.size() == 16);
        for (std::size_t j = 0; j < i; ++j) {
            CHECK(waveform_of(set.vibrations[i]) != waveform_of(set.vibrations[j]));
        }
    }
}

TEST_CASE("assets: what is guessed is called a template, on the set and on every pattern") {
    for (const auto& [name, size] : std::initializer_list<std::pair<const char*, std::size_t>>{
             {"template_hwang_choi_2010", 14},
             {"template_hwang_2017_exp1_low_mid", 7},
             {"template_hwang_2017_exp2", 15},
             {"template_abou_chahine_2022", 14}}) {
        CAPTURE(name);
        const PatternSet set = example(name);
        CHECK(contains(set.name, "template, unconfirmed"));
        CHECK(set.vibrations.size() == size);
        for (const Vibration& vibration : set.vibrations) {
            CHECK(contains(vibration.name, "template, unconfirmed"));
            CHECK(vibration.note.starts_with("TEMPLATE, UNCONFIRMED."));
            CHECK(contains(vibration.note, "Guess: "));
        }
    }
}

TEST_CASE("assets: physiology tables begin with their sources") {
    for (const char* table : {"absolute_thresholds", "firing_rate_slopes", "rate_intensity_fits"}) {
        const std::string_view text = asset("physiology/" + std::string(table) + ".csv");
        CHECK(text.starts_with("# "));
        CHECK(contains(text.substr(0, 400), "\n# Source "));
        CHECK(contains(text, "\n# Confidence "));
    }
}

}  // namespace assets_test
