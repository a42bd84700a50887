// The recordings that a set file names: beside it, elsewhere, gone, and none of its business.
#include "model/io/set/set_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>

#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/set/load.h"
#include "tests/support/set_texts.h"
#include "tests/support/temporary_folder.h"

namespace set_recordings_test {

using namespace tact;
namespace fs = std::filesystem;

TEST_CASE("set file: recordings are read from files beside the set, at the model's rate and in g") {
    const TemporaryFolder folder;
    REQUIRE(fs::create_directory(folder.path / "measured"));
    REQUIRE(write_wave_file(folder.path / "measured/a b.wav",
                            {20'000.0, std::vector<double>(400, 0.5)}));
    REQUIRE(write_text_waveform(folder.path / "t.txt", {kModelRateHz, {1.0, -2.0}}));
    const fs::path file = folder.write("set.tactspace.json", R"({"tactspace": 1, "patterns": [
        {"name": "m", "waveform": "measured/a b.wav", "scale_g": 2.0, "measures": "i", "new": 1},
        {"name": "t", "waveform": "t.txt"}, {"name": "i"}]})");
    const auto loaded = read_set_file(file);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    const auto& measured = std::get<Measurement>(loaded->set.vibrations[0].source);
    CHECK(measured.measures == "i");
    CHECK(measured.scale_g == 2.0);
    REQUIRE(measured.waveform->samples_g.size() == 200);
    CHECK(std::abs(measured.waveform->samples_g[100] - 1.0) <= 1e-4);  // the ends ring a little
    CHECK(loaded->remarks ==
          std::vector<std::string>{"\"m\": resampled from 20,000 Hz to 10,000 Hz"});
    CHECK(std::get<Measurement>(loaded->set.vibrations[1].source).waveform->samples_g ==
          std::vector<double>{1.0, -2.0});

    // Saved to another folder, even through a link, the set still finds them.
    REQUIRE(fs::create_directories(folder.path / "else/where"));
    fs::create_directory_symlink(folder.path / "else/where", folder.path / "link");
    for (const char* place : {"set.tactspace.json", "else/where/set.json", "link/set2.json"}) {
        CAPTURE(place);
        REQUIRE(write_set_file(folder.path / place, loaded->set));
        const auto again = read_set_file(folder.path / place);
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(again->set == loaded->set);
    }
    CHECK(contains(bytes_of(file), "\"waveform\": \"measured/a b.wav\""));
    CHECK(contains(bytes_of(file), "\"new\": 1"));
    CHECK(contains(bytes_of(folder.path / "else/where/set.json"), "\"../../measured/a b.wav\""));

    // An autosave elsewhere names the files in full.
    const auto elsewhere = parse_set(print_set(loaded->set), "autosave", "/");
    REQUIRE(elsewhere);
    CHECK(*elsewhere == loaded->set);
}

TEST_CASE("set file: a missing recording is named with its pattern") {
    const TemporaryFolder folder;
    const auto loaded = read_set_file(folder.write("s.json", R"({"tactspace": 1, "patterns": [
        {"name": "i"}, {"name": "mine", "waveform": "gone.wav"}]})"));
    REQUIRE_FALSE(loaded);
    CHECK(loaded.error().message ==
          (folder.path / "s.json").string() + ": /patterns/1/waveform of \"mine\": " +
              fs::canonical(folder.path).string() + "/gone.wav: there is no such file");
    const auto scale = read_set_file(folder.write(
        "s.json", R"({"tactspace": 1, "patterns": [{"waveform": "a.wav", "scale_g": 0}]})"));
    REQUIRE_FALSE(scale);
    CHECK(contains(scale.error().message, "/patterns/0/scale_g: expected a number from 1e-06"));
}

TEST_CASE("set file: recordings whose path is no UTF-8 are found again") {
    const TemporaryFolder folder;
    const std::string latin = "caf\xE9 100% \xFF";
    const fs::path inside = folder.path / (latin + ".wav");
    const fs::path outside = folder.path / latin / "b.txt";
    REQUIRE(write_wave_file(inside, {kModelRateHz, {0.5, -0.25}}));
    fs::create_directory(folder.path / latin);
    REQUIRE(write_text_waveform(outside, {kModelRateHz, {1.0}}));
    auto set = *load_sets(std::vector<fs::path>{inside, outside});
    for (const fs::path& file : {folder.path / "s.json", folder.path / latin / "s.json"}) {
        REQUIRE(write_set_file(file, set.set));
        CHECK(contains(bytes_of(file), "caf%E9"));
        const auto again = read_set_file(file);
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(std::get<Measurement>(again->set.vibrations[0].source) ==
              std::get<Measurement>(set.set.vibrations[0].source));
        CHECK(std::get<Measurement>(again->set.vibrations[1].source) ==
              std::get<Measurement>(set.set.vibrations[1].source));
    }
    const auto kept = parse_set(print_set(set.set), "autosave", "/");
    REQUIRE_MESSAGE(kept, (kept ? "" : kept.error().message));
    CHECK(*kept == set.set);
    CHECK(contains(set_fault(with_pattern(R"(, "waveform": "%G1", "percent_encoded": true)")),
                   "/patterns/0/waveform: expected two digits"));
    CHECK(contains(set_fault(with_pattern(R"(, "waveform": "a%2", "percent_encoded": true)")),
                   "/patterns/0/waveform: expected two digits"));
}

TEST_CASE("set file: what a set names outside of its folder is heard, but never told") {
    const TemporaryFolder folder;
    folder.write("secret.txt", "root:x:0:0\n");
    folder.write("secret.wav", "root:x:0:0 and much more than a header\n");
    folder.write("loud.wav.json", R"({"scale_g": "root:x:0:0"})");
    REQUIRE(write_wave_file(folder.path / "plain.wav", {kModelRateHz, {0.5}}));
    fs::copy_file(folder.path / "plain.wav", folder.path / "loud.wav");
    folder.write("set/own.txt", "root:x:0:0\n");
    fs::create_symlink("../secret.txt", folder.path / "set/link.txt");
    const auto read = [&](const std::string& name) {
        return read_set_file(
            folder.write("set/s.json", with_pattern(", \"waveform\": \"" + name + "\"")));
    };
    const std::vector<std::string> names{"../secret.txt",     "../secret.wav",
                                         "../loud.wav",       "link.txt",
                                         "../set/link.txt",   (folder.path / "secret.txt").string(),
                                         "x/../../secret.txt"};
    for (const std::string& name : names) {
        CAPTURE(name);
        const auto refused = read(name);
        REQUIRE_FALSE(refused);
        CHECK_FALSE(contains(refused.error().message, "root"));
        CHECK(contains(refused.error().message, "outside of the set's folder"));
    }
    // Its own files, and files opened by themselves, say what is wrong with them.
    CHECK(contains(read("own.txt").error().message, "root:x"));
    CHECK(contains(read("../set/own.txt").error().message, "root:x"));
    CHECK(contains(load_set(folder.path / "secret.txt").error().message, "root:x"));
    CHECK(contains(read("../gone.txt").error().message, "there is no such file"));
    // What users have saved still opens.
    CHECK(read("../plain.wav"));
    CHECK(read((folder.path / "plain.wav").string()));
}

TEST_CASE("set file: a set that names a pipe or a device is refused at once") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder.path / "pipe.txt").c_str(), 0600) == 0);
    fs::create_symlink("/dev/zero", folder.path / "endless.txt");
    for (const char* name : {"pipe.txt", "endless.txt"}) {
        CAPTURE(name);
        const auto set = read_set_file(
            folder.write("s.json", with_pattern(std::string(", \"waveform\": \"") + name + "\"")));
        REQUIRE_FALSE(set);
        CHECK(contains(set.error().message, "expected a file"));
    }
    CHECK(contains(load_set(folder.path / "pipe.txt").error().message, "is a pipe"));
}

}  // namespace set_recordings_test
