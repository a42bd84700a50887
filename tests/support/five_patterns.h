// Five patterns of 0.1 s for tests of the whole program: short, as DTW is quadratic, and not alike.
#pragma once

#include <string>

#include "tests/support/temporary_folder.h"

namespace tact {

// A set file of them; `more`: further fields, each with a comma before it.
inline std::string five_patterns(const std::string& more = {}) {
    return R"({"tactspace": 1, "name": "five", "duration_s": 0.1, "patterns": [
    {"name": "v 1", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 70}]},
    {"name": "v 2", "carriers": [{"frequency_hz": 150}], "modulation": {"frequency_hz": 20}},
    {"name": "v 3", "carriers": [{"frequency_hz": 250}], "rhythm": {"text": "x-", "unit_s": 0.02}},
    {"name": "v 10", "amplitude_g": 0.3, "carriers": [{"frequency_hz": 40}]},
    {"name": "v 11", "carriers": [{"frequency_hz": 70}, {"frequency_hz": 210}]}])" +
           more + "}";
}

struct ShortSet {
    TemporaryFolder folder;
    std::string path = folder.write("short.tactspace.json", five_patterns()).string();
};

}  // namespace tact
