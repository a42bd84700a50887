// tactspace library, as a person at a terminal uses it.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/io/recordings/wave_file.h"
#include "model/io/set/set_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace library_command_test {

using namespace tact;

namespace {

std::string android(int ms, int amplitude) {
    return "<vibration-effect><waveform-effect><waveform-entry durationMs=\"" + std::to_string(ms) +
           "\" amplitude=\"" + std::to_string(amplitude) +
           "\"/></waveform-effect></vibration-effect>";
}

Pattern hum(double hz) {
    Pattern pattern;
    pattern.amplitude_g = 0.7;
    pattern.carriers[0].frequency_hz = hz;
    pattern.duration_s = 0.2;
    return pattern;
}

struct Shelf {
    TemporaryFolder folder;

    Shelf() {
        folder.write("library/LICENSE", "MIT License\n");
        folder.write("library/long.xml", android(300, 255));
        folder.write("library/soft/short.xml", android(100, 80));
        folder.write("library/broken.ahap", "{");
        REQUIRE(write_wave_file(folder.path / "library" / "hum.wav", render(hum(80.0))));
        REQUIRE(write_wave_file(folder.path / "wanted.wav", render(hum(85.0))));
    }
    std::string path(const char* name) const { return (folder.path / name).string(); }
    nlohmann::json ask(std::vector<std::string> more) const {
        std::vector<std::string> all{"library", path("library"), "--json"};
        all.insert(all.end(), more.begin(), more.end());
        return nlohmann::json::parse(output_of(all));
    }
};

std::vector<std::string> names(const nlohmann::json& answer) {
    std::vector<std::string> all;
    for (const auto& entry : answer.at("entries")) all.push_back(entry.at("name"));
    return all;
}

}  // namespace

TEST_CASE("library: a folder is listed, with what could not be read") {
    const Shelf shelf;
    const Ran ran = run_program({"library", shelf.path("library")});
    CHECK(ran.exit_code == 0);
    CHECK(contains(ran.out, "soft/short.xml"));
    CHECK(contains(ran.err, "broken.ahap"));
    CHECK(contains(ran.out, "3 entries in the library. 4 files read now, 1 file not readable"));
    const auto answer = shelf.ask({});
    CHECK(names(answer) == std::vector<std::string>{"hum", "long", "short"});
    CHECK(answer.at("entries")[1].at("licence") == "MIT License");
    CHECK(answer.at("left_out").size() == 1);
    CHECK(answer.at("actuators").contains("android"));
    CHECK(contains(run_program({"library", shelf.path("library")}).out, "0 files read now"));
}

TEST_CASE("library: the nearest first, a limit, and a set of what is listed") {
    const Shelf shelf;
    const std::string out = shelf.path("near.tactspace.json");
    const auto answer = shelf.ask({"--like", shelf.path("wanted.wav"), "-n", "2", "--out", out});
    CHECK(answer.at("like") == "wanted");
    CHECK(answer.at("found") == 3);
    CHECK(answer.at("compared") == 3);
    REQUIRE(answer.at("entries").size() == 2);
    CHECK(names(answer)[0] == "hum");
    CHECK(answer.at("entries")[0].at("pm") <= answer.at("entries")[1].at("pm"));
    const auto set = read_set_file(out);
    REQUIRE(set);
    CHECK(names_of(set->set) == names(answer));
    // By the name of an entry it is the nearest to itself.
    CHECK(names(shelf.ask({"--like", "short"}))[0] == "short");
}

TEST_CASE("library: what can take a place on another device is compared as it comes back") {
    const Shelf shelf;
    const auto answer = shelf.ask({"--like", "long", "--for", "android-xml"});
    CHECK(answer.at("not_held") == 1);
    CHECK(answer.at("itself_pm") == answer.at("entries")[0].at("pm"));
    CHECK(names(answer)[0] == "long");
    CHECK(answer.contains("exported_as"));
}

TEST_CASE("library: words and shapes") {
    const Shelf shelf;
    CHECK(names(shelf.ask({"--search", "MIT soft"})) == std::vector<std::string>{"short"});
    CHECK(names(shelf.ask({"--search", "nothing has this"})).empty());
    const auto answer = shelf.ask({"--shape", "1", "1"});
    CHECK(answer.at("entries").size() == 3);
    CHECK(answer.at("entries")[0].at("shape_off") <= answer.at("entries")[2].at("shape_off"));
}

TEST_CASE("library: what is wrong is one sentence, and nothing is written") {
    const Shelf shelf;
    const std::string library = shelf.path("library");
    const auto refused = [&](std::vector<std::string> more, std::string_view words) {
        std::vector<std::string> all{"library"};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = run_program(all);
        CHECK(ran.exit_code > 0);
        CHECK(ran.out.empty());
        CHECK_MESSAGE(contains(ran.err, words), ran.err);
    };
    refused({shelf.path("nowhere")}, "expected a folder");
    refused({library, "--like", "nobody"}, "expected a file, or a name in the library");
    refused({library, "--like", library}, "expected a file with one effect or recording, got 3");
    refused({library, "--shape", "0", "0"}, "expected two strengths or more");
    refused({library, "--for", "android-xml"}, "--like");
    refused({library, "--like", "long", "--for", "nothing"}, "--for: ");
    refused({library, "--search", "nothing has this", "--out", shelf.path("a.tactspace.json")},
            "expected an entry to write");
    CHECK_FALSE(std::filesystem::exists(shelf.path("a.tactspace.json")));
    const TemporaryFolder empty;
    CHECK(contains(run_program({"library", empty.path.string()}).out, "0 entries"));
    CHECK(run_program({"library", empty.path.string(), "--no-index"}).exit_code == 0);
}

}  // namespace library_command_test
