#include "model/io/set/measured_files.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "model/set/measured_twin.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/three_tones.h"

namespace measured_files_test {

using namespace tact;

namespace {

const Measurement& measurement(const Vibration& vibration) {
    return std::get<Measurement>(vibration.source);
}

}  // namespace

TEST_CASE("measured files: a set with twins is the same set when it is read again") {
    const TemporaryFolder folder;
    const auto file = folder.path / "sub" / "set.tactspace.json";
    std::filesystem::create_directories(file.parent_path());
    PatternSet set = with_synthetic_twins(three_tones(), {});
    REQUIRE(store_measurements(set, file));
    REQUIRE(write_set_file(file, set));
    const auto again = read_set_file(file);
    REQUIRE_MESSAGE(again, again.error().message);
    CHECK(again->set == set);
    CHECK(again->remarks.empty());
    CHECK(measurement(again->set.vibrations[1]).synthetic);
    const std::string text = bytes_of(file);
    CHECK(contains(text, "\"waveform\": \"measured/pulse 1 synthetic.wav\""));
    CHECK(contains(text, "\"waveform\": \"measured/L-4-full synthetic.wav\""));
    CHECK(contains(text, "\"synthetic\": true"));
    CHECK(contains(text, "\"measures\": \"pulse 1\""));
}

TEST_CASE("measured files: nothing that is there is lost, nothing is stored twice") {
    const TemporaryFolder folder;
    const auto file = folder.path / "set.json";
    PatternSet set = with_synthetic_twins(three_tones(), {});
    PatternSet other = set;
    REQUIRE(store_measurements(set, file));
    REQUIRE(store_measurements(other, file));
    CHECK(set == other);
    CHECK(file_count(folder.path / "measured") == 3);
    ActuatorParams noisier;
    noisier.seed = 2;
    PatternSet second = with_synthetic_twins(three_tones(), noisier);
    REQUIRE(store_measurements(second, file));
    CHECK(measurement(second.vibrations[1]).path ==
          (std::filesystem::weakly_canonical(folder.path) / "measured/pulse 1 synthetic 2.wav"));
    CHECK(file_count(folder.path / "measured") == 6);
    folder.write("blocked/measured", "a file");
    PatternSet third = with_synthetic_twins(three_tones(), {});
    CHECK_FALSE(store_measurements(third, folder.path / "blocked" / "set.json"));
    CHECK(measurement(third.vibrations[1]).path.empty());
}

TEST_CASE("measured files: what was kept elsewhere for the time being moves to the set") {
    const TemporaryFolder folder;
    const auto kept = std::filesystem::weakly_canonical(folder.path) / "state";
    PatternSet set = with_synthetic_twins(three_tones(), {});
    for (std::size_t k : {1U, 3U}) {
        auto& of_twin = std::get<Measurement>(set.vibrations[k].source);
        const auto path =
            store_waveform(*of_twin.waveform, set.vibrations[k].name, k == 1 ? kept : folder.path);
        REQUIRE(path);
        of_twin.path = path->string();
    }
    const std::string elsewhere = measurement(set.vibrations[3]).path;
    REQUIRE(store_measurements(set, folder.path / "set.json", kept));
    CHECK(contains(measurement(set.vibrations[1]).path, "/measured/"));
    CHECK(measurement(set.vibrations[3]).path == elsewhere);
}

}  // namespace measured_files_test
