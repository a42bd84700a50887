#include "model/io/recordings/recording.h"

#include <doctest/doctest.h>

#include "tests/support/temporary_folder.h"

namespace recording_test {

using namespace tact;

TEST_CASE("recording: kinds are told by the ending, in any case") {
    CHECK(recording_kind("a.txt") == RecordingKind::text);
    CHECK(recording_kind("folder.json/a.WaV") == RecordingKind::wave);
    CHECK(recording_kind("a.wav.json") == RecordingKind::none);
    CHECK(recording_kind("txt") == RecordingKind::none);
    CHECK(extension_of("a.b.JSON") == ".json");
    const auto other = read_recording("a.mp3");
    REQUIRE_FALSE(other);
    CHECK(other.error().message == "a.mp3: expected a .txt or .wav file");
}

TEST_CASE("recording: text takes a scale too, within what skin can see") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.txt", "1\n-2\n");
    CHECK(read_recording(file)->scale_g == 1.0);
    const auto scaled = read_recording(file, {0.5, {}});
    REQUIRE(scaled);
    CHECK(scaled->waveform.samples_g == std::vector<double>{0.5, -1.0});
    CHECK(scaled->scale_g == 0.5);
    CHECK_FALSE(read_recording(file, {1e6, {}}));
}

}  // namespace recording_test
