// Effects of other programs on the command line: any SET, by the actuator that is named.
#include <doctest/doctest.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace effect_files_test {

namespace {

const std::string kTap = R"({"Pattern": [{"Event": {"Time": 0, "EventType": "HapticTransient"}}]})";
const std::string kBuzz = R"({"timings": [100, 50], "amplitudes": [255, 128], "repeat": -1})";

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != text.npos;
}

}  // namespace

TEST_CASE("effects: predict compares an AHAP with Android's timings, and says what was assumed") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    folder.write("buzz.json", kBuzz);
    const Ran ran = run_program({"predict", folder.path.string()});
    CHECK(ran.exit_code == 0);
    CHECK(has(ran.out, "buzz"));
    CHECK(has(ran.out, "tap"));
    CHECK(has(ran.err, "165 Hz are guessed: such files have no frequency"));
    CHECK(has(ran.err, "actuator map core-haptics ("));
    const std::string a = (folder.path / "tap.ahap").string();
    const std::string b = (folder.path / "buzz.json").string();
    const Ran chosen = run_program({"predict", a, b, "--actuator", "quest"});
    CHECK(chosen.exit_code == 0);
    CHECK(has(chosen.err, "actuator map quest ("));
    CHECK(!has(chosen.err, "core-haptics"));
}

TEST_CASE("effects: an actuator that is neither a name nor a file is refused with the names") {
    const TemporaryFolder folder;
    folder.write("tap.ahap", kTap);
    const Ran ran =
        run_program({"predict", (folder.path / "tap.ahap").string(), "--actuator", "toaster"});
    CHECK(ran.exit_code != 0);
    CHECK(has(ran.err, "--actuator: expected a file (.acf, .json) or one of quest, console-pcm"));
    CHECK(has(ran.err, "got \"toaster\""));
}

}  // namespace effect_files_test
