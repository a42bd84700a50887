// Sets that come with the program, and what it writes of them.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/places.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

inline const std::string kAmSet =
    std::string(tact::kAssetsDir) + "/sets/park_choi_2011_am_5hz.tactspace.json";
inline const std::string kTwelve =
    std::string(tact::kAssetsDir) + "/sets/pm_2023_twelve.tactspace.json";

// The waveforms of a set in a folder of their own, as the program renders them.
struct Rendered {
    TemporaryFolder folder;
    std::string path = folder.path.string();

    Rendered(const std::string& set, const std::string& format) {
        output_of({"render", set, "--format", format, "--out", path});
    }
};

// Without the head.
inline std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& csv) {
    auto rows = cells_of(bytes_of(csv));
    REQUIRE(rows.size() > 1);
    rows.erase(rows.begin());
    return rows;
}
