#include "model/io/set/load.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace load_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

std::string fault(const Expected<Loaded>& loaded) {
    REQUIRE_FALSE(loaded);
    return loaded.error().message;
}

PatternSet set_of_one(const std::string& name) {
    PatternSet set;
    set.name = "set of " + name;
    set.vibrations.push_back({name, Pattern{}, false, "", "", {}});
    return set;
}

}  // namespace

TEST_CASE("load: a set file, a folder and single recordings are told apart") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.samples = {0.5};
    const fs::path sound = folder.write("in/beep.WAV", wave.file());
    const fs::path text = folder.write("in/two.txt", "1\n2\n");
    const fs::path set = folder.path / "s.tactspace.json";
    REQUIRE(write_set_file(set, set_of_one("x")));

    CHECK(load_set(set)->set == set_of_one("x"));
    CHECK(load_set(folder.path / "in")->set.vibrations.size() == 2);
    CHECK(load_set((folder.path / "in").string() + "/")->set.name == "in");
    const auto one = load_set(sound);
    REQUIRE(one);
    CHECK(one->set.name == "beep");
    CHECK(one->set.vibrations.at(0).name == "beep");
    CHECK(one->remarks == std::vector<std::string>{sound.string() + ": full scale taken as 1 g"});
    CHECK(waveform_of(load_set(text)->set.vibrations.at(0)).samples_g ==
          std::vector<double>{1.0, 2.0});
}

TEST_CASE("load: recordings of a folder can be saved as a set and opened again") {
    const TemporaryFolder folder;
    folder.write("in/a.txt", "1\n2\n");
    folder.write("in/b.txt", "3\n4\n");
    const auto loaded = load_set(folder.path / "in");
    REQUIRE(loaded);
    REQUIRE(write_set_file(folder.path / "s.tactspace.json", loaded->set));
    const auto again = load_set(folder.path / "s.tactspace.json");
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->set == loaded->set);
    CHECK(contains(bytes_of(folder.path / "s.tactspace.json"), "\"in/a.txt\""));
}

TEST_CASE("load: what is missing or unknown is refused by name") {
    const TemporaryFolder folder;
    CHECK(fault(load_set("no/such.json")) == "no/such.json: there is no such file");
    CHECK(fault(load_set("no/folder")) == "no/folder: there is no such file");
    const fs::path other = folder.write("a.mp3", "x");
    CHECK(fault(load_set(other)) ==
          other.string() +
              ": expected a set (.tactspace.json), a folder or zip file of .txt, .wav or "
              "effect files, or one such file");
    CHECK(fault(load_sets({})) == "expected at least one set, got none");
}

TEST_CASE("load: several sets become one, of names that differ") {
    const TemporaryFolder folder;
    const fs::path a = folder.path / "a.json";
    const fs::path b = folder.path / "b.json";
    PatternSet second = set_of_one("b");
    second.ratings.push_back({"r", {"b"}, {}, {}});
    second.told_apart.resize(1);
    second.model.nc_weight = 0.25;
    REQUIRE(write_set_file(a, set_of_one("a")));
    REQUIRE(write_set_file(b, second));
    const fs::path text = folder.write("c.txt", "1\n");

    const std::vector<fs::path> all{a, b, text};
    const auto loaded = load_sets(all);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(loaded->set.name == "set of a");
    REQUIRE(loaded->set.vibrations.size() == 3);
    CHECK(loaded->set.vibrations[1].name == "b");
    CHECK(loaded->set.vibrations[2].name == "c");
    CHECK(loaded->set.ratings.size() == 1);
    CHECK(loaded->set.told_apart == second.told_apart);
    CHECK(loaded->set.model == PerceptualModelParams{});
    REQUIRE(loaded->remarks.size() == 1);
    CHECK(contains(loaded->remarks[0], "model parameters of"));

    const std::vector<fs::path> twice{a, b, a};
    CHECK(fault(load_sets(twice)) ==
          a.string() + ": \"a\" is a name in " + a.string() + " too, expected names that differ");
    const std::vector<fs::path> gone{a, folder.path / "gone.txt"};
    CHECK(contains(fault(load_sets(gone)), "gone.txt: there is no such file"));
}

TEST_CASE("load: of several paths, partly, what can be read is read and the rest named") {
    const TemporaryFolder folder;
    const fs::path set = folder.path / "s.json";
    REQUIRE(write_set_file(set, set_of_one("a")));
    fs::create_directory(folder.path / "in");
    folder.write("in/a.txt", "1\n");
    folder.write("in/bad.wav", "RIFF");
    const std::vector<fs::path> paths{folder.path / "gone.ahap", set, folder.path / "in", set};
    LoadOptions partly;
    partly.partly = true;
    const auto loaded = load_sets(paths, partly);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(loaded->set.name == "set of a");
    REQUIRE(loaded->set.vibrations.size() == 2);
    CHECK(loaded->set.vibrations[1].name == "a 2");
    CHECK(counts_text(*loaded) == "2 files read, 3 not");
    REQUIRE(loaded->left_out.size() == 3);
    CHECK(contains(loaded->left_out[0], "gone.ahap: there is no such file"));
    CHECK(contains(loaded->left_out[1], "bad.wav"));
    CHECK(contains(loaded->left_out[2], "\"a\" is a name in"));
    CHECK_FALSE(load_sets(paths));
    const std::vector<fs::path> none{folder.path / "gone.ahap", folder.path / "gone.wav"};
    CHECK(contains(fault(load_sets(none, partly)), "and 1 more were not read"));
}

}  // namespace load_test
