// Rhythms of thousands of notes, in a set file.
#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "tests/support/temporary_folder.h"

namespace long_rhythm_test {

using namespace tact;

TEST_CASE("set file: a rhythm of 10,000 notes of nine strengths comes back as it was") {
    const TemporaryFolder folder;
    PatternSet set;
    Pattern pattern;
    pattern.rhythm.unit_s = 0.003;
    for (int k = 0; k < 10'000; ++k) {
        pattern.rhythm.text += k % 9 == 0 ? 'x' : static_cast<char>('0' + k % 9);
        pattern.rhythm.text += '-';
    }
    pattern.duration_s = 60.0;
    Vibration& vibration = set.vibrations.emplace_back();
    vibration.name = "long";
    vibration.source = pattern;
    const auto path = folder.path / "long.tactspace.json";
    REQUIRE(write_set_file(path, set));
    const auto read = read_set_file(path);
    REQUIRE(read);
    CHECK(std::get<Pattern>(read->set.vibrations.front().source) == pattern);
    CHECK(notes(pattern.rhythm, pattern.duration_s).size() == 10'000);
}

}  // namespace long_rhythm_test
