// What "tactspace play" says where nothing is played; tests/e2e/play_* listen to what is.

#include <doctest/doctest.h>

#include "tests/support/places.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace play_command_test {

namespace {

const std::string kExample = std::string(tact::kAssetsDir) + "/sets/pm_2023_twelve.tactspace.json";

}  // namespace

TEST_CASE("play: one pattern or all, and one that there is") {
    const Ran neither = run_program({"play", kExample});
    CHECK(neither.exit_code == 2);
    CHECK(contains(neither.err, "--pattern NAME or --all is required"));
    CHECK(run_program({"play", kExample, "--pattern", "x", "--all"}).exit_code == 2);
    CHECK(contains(refusal_of({"play", kExample, "--pattern", "nobody"}), "nobody"));
}

TEST_CASE("play: a level or a channel count that cannot be is bad usage") {
    for (const std::string level : {"-0.1", "1.1", "loud", "nan", "-nan", "inf"}) {
        CHECK(run_program({"play", kExample, "--all", "--level", level}).exit_code == 2);
    }
    for (const std::string option : {"--gap", "--full-scale", "--buffer", "--longest"}) {
        CHECK(run_program({"play", kExample, "--all", option, "nan"}).exit_code == 2);
    }
    CHECK(run_program({"play", kExample, "--all", "--channels", "99"}).exit_code == 2);
}

TEST_CASE("devices: the list is one to be read by programs, and libraries are silent") {
    // A sanitizer would find memory of libraries that are gone by then.
    const Ran ran = run_program({"devices", "--json"}, "export ASAN_OPTIONS=detect_leaks=0");
    CHECK(ran.exit_code == 0);
    CHECK(ran.err == "");
    CHECK(ran.out.starts_with("["));
    CHECK(ran.out.ends_with("]\n"));
}

}  // namespace play_command_test
