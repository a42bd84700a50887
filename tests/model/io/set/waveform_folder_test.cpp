#include "model/io/set/waveform_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <stop_token>

#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace waveform_folder_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names(const PatternSet& set) {
    std::vector<std::string> result;
    for (const Vibration& vibration : set.vibrations) result.push_back(vibration.name);
    return result;
}

std::string fault(const Expected<Loaded>& loaded) {
    REQUIRE_FALSE(loaded);
    return loaded.error().message;
}

}  // namespace

TEST_CASE("waveform folder: files become vibrations in the order in which people count") {
    const TemporaryFolder folder;
    for (const char* stem : {"v_10", "v_2", "v_1", "\u9707\u52a8 10", "\u9707\u52a8 9"}) {
        folder.write(std::string(stem) + ".txt", "0.5\n-0.5\n");
    }
    const auto loaded = read_text_folder(folder.path);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(names(loaded->set) ==
          std::vector<std::string>{"v_1", "v_2", "v_10", "\u9707\u52a8 9", "\u9707\u52a8 10"});
    CHECK(loaded->set.name == folder.path.filename().string());
    CHECK(loaded->remarks.empty());
    CHECK(waveform_of(loaded->set.vibrations[0]).samples_g == std::vector<double>{0.5, -0.5});
}

TEST_CASE("waveform folder: what is odd is accepted and said once") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.samples = {0.5, 0.25, 0.125};
    for (const char* name : {"b3.wav", "b1.WAV", "b2.wav"}) folder.write(name, wave.file());
    folder.write("a.txt", "1\r\n2\r\n");
    folder.write("notes.md", "");
    folder.write("b2.wav.json", "{\"scale_g\": 1}");
    folder.write(".hidden", "");
    fs::create_directory(folder.path / "below");
    const auto loaded = read_waveform_folder(folder.path);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(names(loaded->set) == std::vector<std::string>{"a", "b1", "b2", "b3"});
    const std::string place = folder.path.string();
    CHECK(loaded->remarks ==
          std::vector<std::string>{
              place + "/b1.WAV and 1 more: full scale taken as 1 g",
              place + ": lengths of 2 to 3 samples, the shorter ones are padded with zeros",
              place + ": 1 other file ignored"});
    CHECK(names(read_text_folder(folder.path)->set) == std::vector<std::string>{"a"});
}

TEST_CASE("waveform folder: where nothing can be read it is refused with a reason") {
    const TemporaryFolder folder;
    const std::string place = folder.path.string();
    CHECK(fault(read_waveform_folder(folder.path)) ==
          place + ": expected at least one .txt or .wav or effect file in this folder, got none");
    CHECK(contains(fault(read_text_folder(folder.path / "none")), "No such file or directory"));
    folder.write("b.txt", "1\nNaN\n");
    CHECK(fault(read_text_folder(folder.path)) ==
          place + "/b.txt:2: expected one finite number, got \"NaN\"");
    fs::create_symlink("gone", folder.path / "link.txt");
    CHECK(fault(read_text_folder(folder.path)) ==
          place + "/b.txt:2: expected one finite number, got \"NaN\"; and 1 more were not read");
}

TEST_CASE("waveform folder: a bad file leaves the others, and is named with its reason") {
    const TemporaryFolder folder;
    const std::string place = folder.path.string();
    folder.write("a.txt", "1\n");
    folder.write("b.txt", "1\nNaN\n");
    folder.write("c.wav", "RIFF");
    folder.write("d.haptic", "{");
    folder.write("e.json", R"({"signals": 3})");
    folder.write("f.ahap", "");
    WaveBytes wave;
    wave.samples = {0.5, 0.25};
    folder.write("g.wav", wave.file());
    fs::create_symlink("gone", folder.path / "h.txt");
    folder.write("i.json", R"({"timings": [10, 10], "amplitudes": [255, 0]})");
    const auto loaded = read_waveform_folder(folder.path);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(names(loaded->set) == std::vector<std::string>{"a", "g", "i"});
    CHECK(counts_text(*loaded) == "3 files read, 6 not");
    REQUIRE(loaded->left_out.size() == 6);
    CHECK(loaded->left_out[0] == place + "/b.txt:2: expected one finite number, got \"NaN\"");
    const char* stems[] = {"b.txt", "c.wav", "d.haptic", "e.json", "f.ahap", "h.txt"};
    for (std::size_t k = 0; k < 6; ++k) {
        CAPTURE(loaded->left_out[k]);
        CHECK(loaded->left_out[k].starts_with(place + "/" + stems[k]));
    }
}

TEST_CASE("waveform folder: folders within it are read too, and no name is given twice") {
    const TemporaryFolder folder;
    folder.write("a.txt", "1\n");
    folder.write("a.TXT", "2\n");
    fs::create_directories(folder.path / "low/deep");
    fs::create_directories(folder.path / ".git");
    fs::create_directories(folder.path / "own/measured");
    folder.write("low/a.txt", "3\n");
    folder.write("low/deep/b.txt", "4\n");
    folder.write(".git/c.txt", "5\n");
    folder.write("own/s.tactspace.json", R"({"tactspace": 1, "patterns": []})");
    folder.write("own/measured/d.txt", "6\n");
    fs::create_directory_symlink("..", folder.path / "low/up");
    const auto loaded = read_waveform_folder(folder.path);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(names(loaded->set) == std::vector<std::string>{"a", "a.txt", "a.txt 2", "b"});
    REQUIRE(loaded->left_out.size() == 1);
    CHECK(contains(loaded->left_out[0], "low/up: a link to a folder is not followed"));
    const auto says = [&](const std::string& words) {
        return std::ranges::any_of(
            loaded->remarks, [&](const std::string& remark) { return contains(remark, words); });
    };
    CHECK(says("s.tactspace.json: is a set of its own"));
    CHECK(says("is called \"a.txt\", as its name is taken"));
}

TEST_CASE("waveform folder: reading ends where it is told to, and says how far it is") {
    const TemporaryFolder folder;
    for (const char* name : {"a.txt", "b.txt", "c.txt", "d.txt"}) folder.write(name, "1\n");
    std::stop_source source;
    std::vector<double> shares;
    const LoadOptions options{{}, false, source.get_token(), [&](double share) {
                                  shares.push_back(share);
                                  if (shares.size() == 2) source.request_stop();
                              }};
    CHECK(fault(read_waveform_folder(folder.path, options)) == kReadingCancelled);
    CHECK(shares == std::vector<double>{0.25, 0.5});
}

TEST_CASE("waveform folder: a file name that is not UTF-8 still gives a name") {
    const TemporaryFolder folder;
    folder.write("a\xFF.txt", "1\n");
    const auto loaded = read_text_folder(folder.path);
    REQUIRE(loaded);
    CHECK(names(loaded->set) == std::vector<std::string>{"a\uFFFD"});
}

TEST_CASE("waveform folder: ten thousand short files load, one more is too many" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    for (int k = 0; k < 10'000; ++k) folder.write(std::to_string(k) + ".txt", "0\n0.5\n1\n");
    const auto loaded = read_text_folder(folder.path);
    REQUIRE(loaded);
    CHECK(loaded->set.vibrations.size() == 10'000);
    CHECK(loaded->set.vibrations[9999].name == "9999");
    folder.write("x.txt", "0\n");
    CHECK(contains(fault(read_text_folder(folder.path)),
                   "expected at most 10,000 files, got 10,001"));
}

}  // namespace waveform_folder_test
