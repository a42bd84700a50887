// Effects of other programs wherever a set is named: single files, folders, several at once.
#include <doctest/doctest.h>

#include <algorithm>

#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "tests/support/temporary_folder.h"

namespace effects_set_test {

using namespace tact;

namespace {

const std::string kTap =
    R"({"Version": 1, "Pattern": [{"Event": {"Time": 0, "EventType": "HapticTransient",
    "EventParameters": [{"ParameterID": "HapticSharpness", "ParameterValue": 0.5}]}}]})";
const std::string kBuzz = R"({"timings": [100, 50], "amplitudes": [255, 128], "repeat": -1})";
const std::string kClip =
    R"({"version": {"major": 1}, "signals": {"continuous": {"envelopes": {"amplitude":
    [{"time": 0, "amplitude": 1}, {"time": 0.5, "amplitude": 0}]}}}})";
const std::string kXml = R"(<vibration-effect><waveform-envelope-effect>
    <control-point amplitude="1" frequencyHz="100" durationMs="20"/></waveform-envelope-effect></vibration-effect>)";

std::vector<std::string> names(const PatternSet& set) { return names_of(set); }

bool says(const Loaded& loaded, const std::string& words) {
    return std::ranges::any_of(loaded.remarks, [&](const std::string& remark) {
        return remark.find(words) != remark.npos;
    });
}

std::string fault(const Expected<Loaded>& loaded) { return loaded ? "" : loaded.error().message; }

}  // namespace

TEST_CASE("effects in sets: a folder that mixes formats and recordings is one set") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    folder.write("buzz.json", kBuzz);
    folder.write("tap.haptic", kClip);
    folder.write("pulse.xml", kXml);
    folder.write("wave.txt", "0\n1\n0\n");
    folder.write("package.json", R"({"name": "nothing of ours"})");
    folder.write("broken.json", R"({"timings": [1)");
    folder.write("README", "hello");
    const auto loaded = load_set(folder.path);
    REQUIRE_MESSAGE(loaded, fault(loaded));
    CHECK(names(loaded->set) ==
          std::vector<std::string>{"buzz", "pulse", "tap", "tap.haptic", "wave"});
    CHECK(says(*loaded, "2 other files ignored"));
    REQUIRE(loaded->left_out.size() == 1);
    CHECK(contains(loaded->left_out[0], "broken.json, line 1, column "));
    CHECK(says(*loaded, "tap.ahap: actuator map core-haptics ("));
    CHECK(says(*loaded, "1 g at full scale is assumed"));
    const Vibration& tap = loaded->set.vibrations[2];
    CHECK(tap.note.starts_with("From tap.ahap (AHAP). Actuator map core-haptics: Hz, gains and"));
    CHECK(std::get<Pattern>(tap.source).transients.size() == 1);
}

const std::string kRest =
    R"({"Version": 1, "Pattern": [{"Event": {"Time": 0, "EventType": "HapticContinuous",
    "EventDuration": 0.4, "EventParameters": []}}]})";

TEST_CASE(
    "effects in sets: the two files of an AHAP pair are one pattern, wherever both are named") {
    const TemporaryFolder folder;
    const auto first = folder.write("buzz_continuous.ahap", kRest);
    const auto second = folder.write("buzz_transients.ahap", kTap);
    folder.write("a_transients.ahap", kTap);  // without its other half
    const auto whole = load_set(folder.path);
    REQUIRE_MESSAGE(whole, fault(whole));
    CHECK(names(whole->set) == std::vector<std::string>{"a_transients", "buzz"});
    const auto& pair = std::get<Pattern>(whole->set.vibrations[1].source);
    CHECK(pair.transients.size() == 1);
    CHECK(envelope_g(pair, 0.2) > 0.1);
    CHECK(says(*whole, "buzz_continuous.ahap: one pattern with buzz_transients.ahap"));
    CHECK(whole->set.vibrations[1].note.starts_with(
        "From buzz_continuous.ahap and buzz_transients.ahap (AHAP)."));
    for (const auto& paths : {std::vector{first, second}, std::vector{second, first}}) {
        const auto named = load_sets(paths);
        REQUIRE_MESSAGE(named, fault(named));
        CHECK(names(named->set) == std::vector<std::string>{"buzz"});
        CHECK(named->set.vibrations[0].source == whole->set.vibrations[1].source);
        CHECK(named->set.name == "buzz");
    }
    const auto half = load_set(first);
    REQUIRE_MESSAGE(half, fault(half));
    CHECK(names(half->set) == std::vector<std::string>{"buzz_continuous"});
    CHECK(says(*half, "its transients in buzz_transients.ahap are not read"));
    // Another project: two patterns.
    folder.write("buzz_transients.ahap", R"({"Metadata": {"Project": "other"}, )" + kTap.substr(1));
    CHECK(names(load_set(folder.path)->set) ==
          std::vector<std::string>{"a_transients", "buzz_continuous", "buzz_transients"});
}

TEST_CASE("effects in sets: the map's name is kept with each pattern, in its file and back") {
    const TemporaryFolder folder;
    folder.write("in/tap.ahap", kTap);
    folder.write("in/clip.haptic", kClip);
    const auto loaded = load_set(folder.path / "in", bundled_actuator("console-pcm"));
    REQUIRE(loaded);
    CHECK(loaded->set.vibrations[0].effect == EffectOrigin{"haptic", "console-pcm"});
    CHECK(loaded->set.vibrations[1].effect == EffectOrigin{"ahap", "console-pcm"});
    CHECK(actuators_of(loaded->set) == std::map<std::string, std::size_t>{{"console-pcm", 2}});
    const auto file = folder.path / "kept.tactspace.json";
    REQUIRE(write_set_file(file, loaded->set));
    const auto back = load_set(file, bundled_actuator("quest"));  // is in g and Hz by now
    REQUIRE(back);
    CHECK(back->set == loaded->set);
    CHECK(says(*back, ": 2 patterns were read by actuator map \"console-pcm\""));
}

TEST_CASE("effects in sets: a file without a map is written as it was") {
    const std::string text =
        R"({"tactspace": 1, "name": "x", "patterns": [{"name": "a"}, {"name": "b"}]})";
    const auto set = parse_set(text, "x.json", {});
    REQUIRE(set);
    const std::string printed = print_set(*set);
    CHECK(printed.find("effect") == std::string::npos);
    CHECK(print_set(*parse_set(printed, "x.json", {})) == printed);
    const auto kept = parse_set(
        R"({"tactspace": 1, "patterns": [{"name": "a", "effect": {"actuator": "q", "new": 1}}]})",
        "x.json", {});
    REQUIRE(kept);
    CHECK(kept->vibrations[0].effect.actuator == "q");
    CHECK(print_set(*kept).find("\"new\": 1") != std::string::npos);
    const auto refused =
        parse_set(R"({"tactspace": 1, "patterns": [{"effect": {"actuator": 3}}]})", "x.json", {});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "x.json: /patterns/0/effect/actuator: expected a text, got 3");
}

TEST_CASE("effects in sets: a faulty file of a format is left out of its folder with a sentence") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    folder.write("bad.haptic", R"({"version": {"major": 1}, "signals": 3})");
    const auto loaded = load_set(folder.path);
    REQUIRE_MESSAGE(loaded, fault(loaded));
    CHECK(names(loaded->set) == std::vector<std::string>{"tap"});
    CHECK(loaded->left_out == std::vector<std::string>{(folder.path / "bad.haptic").string() +
                                                       ": /signals: expected an object, got 3"});
}

TEST_CASE("effects in sets: content tells a file, whatever its name") {
    const TemporaryFolder folder;
    folder.write("clip.any", kClip);
    folder.write("set.json", R"({"tactspace": 1, "patterns": []})");
    const auto loaded = load_set(folder.path / "clip.any");
    REQUIRE_MESSAGE(loaded, fault(loaded));
    CHECK(names(loaded->set) == std::vector<std::string>{"clip"});
    CHECK(holds_effects(folder.path / "clip.any"));
    CHECK(!holds_effects(folder.path / "set.json"));
    CHECK(load_set(folder.path / "set.json"));
}

TEST_CASE("effects in sets: the actuator that is chosen is what Hz come from") {
    const TemporaryFolder folder;
    folder.write("clip.haptic", kClip);
    const auto own = load_set(folder.path / "clip.haptic");
    const auto chosen = load_set(folder.path / "clip.haptic", bundled_actuator("core-haptics"));
    REQUIRE(own);
    REQUIRE(chosen);
    const auto hz = [](const Loaded& loaded) {
        return std::get<Pattern>(loaded.set.vibrations[0].source).carriers[0].frequency_hz;
    };
    CHECK(hz(*own) == 127.5);
    CHECK(hz(*chosen) == 182.5);
    CHECK(chosen->set.vibrations[0].note.find("Actuator map core-haptics") != std::string::npos);
}

TEST_CASE("effects in sets: of several files, an effect whose name is taken gets its ending") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    folder.write("tap.haptic", kClip);
    const std::vector<std::filesystem::path> paths{
        folder.path / "tap.ahap", folder.path / "tap.haptic", folder.path / "tap.haptic"};
    const auto loaded = load_sets(paths);
    REQUIRE_MESSAGE(loaded, fault(loaded));
    CHECK(names(loaded->set) == std::vector<std::string>{"tap", "tap.haptic", "tap.haptic 2"});
}

TEST_CASE("effects in sets: what was read is saved as a set, notes and all") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    folder.write("tap.haptic", kClip);
    const auto loaded = load_set(folder.path);
    REQUIRE(loaded);
    const auto again = parse_set(print_set(loaded->set), "again", {});
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == loaded->set);
}

}  // namespace effects_set_test
