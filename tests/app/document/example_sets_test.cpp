#include "app/document/editing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "assets/assets.h"
#include "model/io/set/set_file.h"

namespace example_sets_test {

using namespace tact;

TEST_CASE("example sets: the menu has every set that comes with the program, by its own name") {
    std::set<std::string> listed;
    for (const ExampleSet& example : kExampleSets) {
        CAPTURE(example.path);
        const auto set = parse_set(asset(example.path), example.path, {});
        REQUIRE(set);
        CHECK(set->name == example.name);
        CHECK(listed.insert(example.path).second);
    }
    for (const Asset& file : assets()) {
        if (file.path.ends_with(".tactspace.json")) CHECK(listed.contains(std::string(file.path)));
    }
}

TEST_CASE(
    "example sets: the library has forty patterns of six families, none of them a recording") {
    const auto set = parse_set(asset(kExampleSets[1].path), kExampleSets[1].path, {});
    REQUIRE(set);
    CHECK(set->vibrations.size() == 40);
    std::set<std::string> families;
    std::size_t drawn = 0;
    std::size_t with_rhythm = 0;
    for (const Vibration& vibration : set->vibrations) {
        CAPTURE(vibration.name);
        REQUIRE(std::holds_alternative<Pattern>(vibration.source));
        const Pattern& pattern = std::get<Pattern>(vibration.source);
        families.insert(vibration.note.substr(0, vibration.note.find(':')));
        drawn += is_drawn(pattern) ? 1 : 0;
        with_rhythm += pattern.rhythm.text.empty() ? 0 : 1;
        CHECK(vibration.note.ends_with("Made for tactspace; from no study."));
        CHECK(peak_g(waveform_of(vibration)) > 0.05);  // none is silent
    }
    CHECK((families ==
           std::set<std::string>{"Alarm", "Heartbeat", "Pulse", "Swell", "Texture", "Tick"}));
    CHECK(drawn >= 10);
    CHECK(with_rhythm >= 5);
}

TEST_CASE(
    "example sets: notes, accents and layers are there to be looked at, and come back as they "
    "are") {
    const char* path = "library/notes_accents_layers.tactspace.json";
    const auto set = parse_set(asset(path), path, {});
    REQUIRE(set);
    std::size_t pitched = 0;
    std::size_t accented = 0;
    std::size_t layered = 0;
    std::size_t barred = 0;
    for (const Vibration& vibration : set->vibrations) {
        CAPTURE(vibration.name);
        CHECK(vibration.note.ends_with("Made for tactspace; from no study."));
        CHECK(peak_g(waveform_of(vibration)) > 0.05);
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        layered += pattern == nullptr ? 1 : 0;
        if (pattern == nullptr) continue;
        pitched += has_pitches(pattern->rhythm) ? 1 : 0;
        accented += has_accents(*pattern) ? 1 : 0;
        barred += pattern->rhythm.meter.beats_a_bar > 0 ? 1 : 0;
    }
    CHECK(pitched >= 2);
    CHECK(accented >= 1);
    CHECK(layered >= 2);
    CHECK(barred >= 1);
    const auto again = parse_set(print_set(*set), path, {});
    REQUIRE(again);
    CHECK(*again == *set);
}

}  // namespace example_sets_test
