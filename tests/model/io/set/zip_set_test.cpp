// A zip file is a set as the folder is that was packed.
#include <doctest/doctest.h>

#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_bytes.h"

namespace zip_set_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

constexpr const char* kAhap =
    R"({"Version":1,"Pattern":[{"Event":{"Time":0,"EventType":"HapticTransient",)"
    R"("EventParameters":[{"ParameterID":"HapticIntensity","ParameterValue":1}]}}]})";

std::vector<ZipMember> mixed() {
    WaveBytes wave;
    wave.samples = {0.5, -0.25, 0.125};
    return {{"deep/er/tick.ahap", kAhap},
            {"bad.ahap", "{"},
            {"wave.wav", wave.file()},
            {"wave.wav.json", R"({"scale_g": 2})"},
            {"deep/line.txt", "0.5\n-0.5\n"},
            {"readme.md", "words"},
            {"inner.zip", zip_of({{"a.txt", "1\n"}})},
            {"study.tactspace.json", R"({"tactspace":1})"},
            {"measured/twin.wav", wave.file()}};
}

// Sentences without the place.
std::vector<std::string> without(std::vector<std::string> sentences, const std::string& place) {
    for (std::string& one : sentences) {
        for (std::size_t at; (at = one.find(place)) != one.npos;) one.erase(at, place.size());
    }
    return sentences;
}

}  // namespace

TEST_CASE("zip set: reads as the folder that was packed, remarks and refusals too") {
    const TemporaryFolder folder;
    for (const ZipMember& one : mixed()) folder.write(fs::path("plain") / one.name, one.bytes);
    const fs::path zip = folder.write("packed.zip", zip_of(mixed()));
    auto of_zip = load_set(zip);
    auto of_folder = load_set(folder.path / "plain");
    REQUIRE_MESSAGE(of_zip, (of_zip ? "" : of_zip.error().message));
    REQUIRE_MESSAGE(of_folder, (of_folder ? "" : of_folder.error().message));
    CHECK(of_zip->set.name == "packed");
    REQUIRE(of_zip->set.vibrations.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vibration& one = of_zip->set.vibrations[k];
        const Vibration& other = of_folder->set.vibrations[k];
        CHECK(one.name == other.name);
        CHECK(one.note == other.note);
        CHECK(waveform_of(one).samples_g == waveform_of(other).samples_g);
    }
    CHECK(waveform_of(of_zip->set.vibrations[0]).samples_g[0] == doctest::Approx(1.0));
    const std::string place = folder.path.string();
    CHECK(without(of_zip->remarks, place + "/packed.zip") ==
          without(of_folder->remarks, place + "/plain"));
    CHECK(without(of_zip->left_out, place + "/packed.zip") ==
          without(of_folder->left_out, place + "/plain"));
    CHECK(of_zip->left_out.size() == 2);
    CHECK(of_zip->files == of_folder->files);
}

TEST_CASE("zip set: a set that is saved finds its recordings in the zip file again") {
    const TemporaryFolder folder;
    const auto loaded = load_set(folder.write("packed.zip", zip_of(mixed())));
    REQUIRE(loaded);
    const fs::path file = folder.path / "kept.tactspace.json";
    REQUIRE(write_set_file(file, loaded->set));
    const auto again = load_set(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->set == loaded->set);
    CHECK(bytes_of(file).find("\"packed.zip/wave.wav\"") != std::string::npos);
    std::size_t entries = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path)) {
        static_cast<void>(entry);
        ++entries;
    }
    CHECK(entries == 2);  // nothing was unpacked
}

TEST_CASE("zip set: where nothing can be read the sentence says why") {
    const TemporaryFolder folder;
    const auto fault = [](const fs::path& path) {
        const auto loaded = load_set(path);
        return loaded ? std::string() : loaded.error().message;
    };
    const fs::path empty = folder.write("empty.zip", zip_of({}));
    CHECK(fault(empty) == empty.string() +
                              ": expected at least one .txt or .wav or effect file in this zip "
                              "file, got none");
    ZipMember secret{"a.wav", "RIFF"};
    secret.is_encrypted = true;
    const fs::path locked = folder.write("locked", zip_of({secret}));
    CHECK(fault(locked) ==
          locked.string() + ": \"a.wav\": is encrypted: expected a zip file without a password");
}

}  // namespace zip_set_test
