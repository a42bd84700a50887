// Actuator maps of effects in the window: shown when effects are opened, and changed.
#include "app/patterns/patterns.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/window/window.h"
#include "model/io/set/load.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace effect_maps_dialog_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

const std::string kTap =
    R"({"Version": 1, "Pattern": [{"Event": {"Time": 0, "EventType": "HapticContinuous",
    "EventDuration": 0.1, "EventParameters": []}}]})";
const std::string kBuzz = R"({"timings": [100, 50], "amplitudes": [255, 128], "repeat": -1})";

struct Effects {
    TemporaryFolder folder;
    Program program{short_patterns(0)};

    Effects() {
        program.app.ui.motion = false;
        folder.write("in/tap.ahap", kTap);
        folder.write("in/top.ahap", kTap);
        folder.write("in/buzz.json", kBuzz);
        open_paths(program.app.ui, program.app.work, program.app.opening, {folder.path / "in"});
        program.settle();
    }

    PatternSet& set() { return program.app.work.document.edit(); }
    const Vibration& named(const std::string& name) {
        return set().vibrations[*place_named(set(), name)];
    }
    std::string status() { return program.app.ui.status.text; }

    void read_ahap_by(const std::string& map) {
        if (program.app.ui.dialog == kNoDialog) program.click("button:change maps");
        program.click("effects:map of ahap");
        program.click("effects map:" + map);
    }
};

bool is_enabled(const Program& program, const std::string& name) {
    const auto all = commands();
    const auto found = std::ranges::find(all, name, &Command::name);
    REQUIRE(found != all.end());
    return found->enabled(program.app);
}

}  // namespace

TEST_CASE("effect maps: without an effect the dialog says what brings one") {
    Program program(short_patterns(1));
    program.app.ui.dialog = kEffectMapsDialog;
    program.settle();
    CHECK(contains(program.at("effects:none").value, "Add to set..."));
}

TEST_CASE("effect maps: what was opened says by which maps it was read, until that is hidden") {
    Effects effects;
    CHECK(effects.program.at("effects:maps").value == "android, core-haptics");
    effects.program.click("button:hide maps");
    CHECK_FALSE(effects.program.shows("effects:maps"));
    CHECK(is_enabled(effects.program, "Actuator maps..."));
    const Program plain(short_patterns(2));
    CHECK_FALSE(is_enabled(plain, "Actuator maps..."));
    CHECK_FALSE(plain.shows("effects:maps"));
}

TEST_CASE("effect maps: a chosen one reads its format again, as one step, and is kept") {
    Effects effects;
    const PatternSet before = effects.set();
    effects.read_ahap_by("quest");
    const auto quest = load_set(effects.folder.path / "in", bundled_actuator("quest"));
    REQUIRE(quest);
    for (const char* name : {"tap", "top"}) {
        const Vibration& want = quest->set.vibrations[*place_named(quest->set, name)];
        CHECK(effects.named(name).source == want.source);
        CHECK(effects.named(name).note == want.note);
        CHECK(effects.named(name).effect == EffectOrigin{"ahap", "quest"});
    }
    CHECK(effects.named("buzz") == before.vibrations[*place_named(before, "buzz")]);
    CHECK(effects.status() == "Read 2 patterns of AHAP by quest.");
    CHECK(effects.program.at("effects:map of ahap").value == "quest");
    effects.program.press_key(key::kEscape);
    effects.program.press('z', true);
    CHECK(effects.set() == before);
    CHECK(effects.program.at("effects:maps").value == "android, core-haptics");
    // After undo it continues from the restored set.
    effects.read_ahap_by("console-pcm");
    CHECK(effects.named("tap").effect.actuator == "console-pcm");
    CHECK(effects.named("top").effect.actuator == "console-pcm");
}

TEST_CASE(
    "effect maps: renamed ones are read again, edited and locked ones are left, and counted") {
    Effects effects;
    PatternSet& set = effects.set();
    set.vibrations[*place_named(set, "top")].name = "renamed";
    std::get<Pattern>(set.vibrations[*place_named(set, "tap")].source).amplitude_g = 0.123;
    document_changed(effects.program.app.work);
    effects.read_ahap_by("quest");
    CHECK(effects.named("renamed").effect.actuator == "quest");
    CHECK(std::get<Pattern>(effects.named("tap").source).amplitude_g == 0.123);
    CHECK(effects.named("tap").effect.actuator == "core-haptics");
    CHECK(effects.status() ==
          "Read 1 pattern of AHAP by quest. 1 pattern edited since or locked: left.");
    set.vibrations[*place_named(set, "renamed")].locked = true;
    effects.read_ahap_by("console-pcm");
    CHECK(effects.named("renamed").effect.actuator == "quest");
}

TEST_CASE("effect maps: files that are gone or changed are one sentence, and nothing changes") {
    Effects effects;
    const PatternSet before = effects.set();
    effects.folder.write("in/new.ahap", kTap);
    effects.read_ahap_by("quest");
    CHECK(effects.program.app.ui.status.is_error);
    CHECK(effects.status().ends_with("has changed since it was read"));
    fs::remove_all(effects.folder.path / "in");
    effects.read_ahap_by("console-pcm");
    CHECK(effects.status().starts_with("Not read again: "));
    CHECK(effects.set() == before);
}

TEST_CASE("effect maps: of a saved set the maps are known, its files are not") {
    Effects effects;
    const fs::path file = effects.folder.path / "kept.tactspace.json";
    effects.read_ahap_by("quest");
    effects.program.press_key(key::kEscape);
    save_as(effects.program.app.ui, effects.program.app.work, file);
    open_paths(effects.program.app.ui, effects.program.app.work, effects.program.app.opening,
               {file});
    effects.program.settle();
    CHECK(effects.named("tap").effect == EffectOrigin{"ahap", "quest"});
    const auto uses = maps_in_use(effects.program.app.work);
    REQUIRE(uses.size() == 2);
    CHECK(uses[0].actuators == "quest");
    CHECK_FALSE(uses[0].has_files);
    CHECK_FALSE(effects.program.shows("effects:maps"));
}

TEST_CASE("effect maps: added effects are told, too, and read again by themselves") {
    Program program(short_patterns(2));
    const TemporaryFolder folder;
    const fs::path tap = folder.write("tap.ahap", kTap);
    add_paths(program.app.ui, program.app.work, program.app.opening, {tap});
    program.settle();
    CHECK(program.at("effects:maps").value == "core-haptics");
    read_by_map(program.app.ui, program.app.work, "ahap", "quest");
    const PatternSet& set = program.app.work.document.set;
    CHECK(set.vibrations[*place_named(set, "tap")].effect.actuator == "quest");
    CHECK(set.vibrations[*place_named(set, "p1")] == short_patterns(2).vibrations[0]);
}

}  // namespace effect_maps_dialog_test
