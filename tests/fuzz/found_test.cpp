#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>

#include "tests/fuzz/readers.h"
#include "tests/support/mutations.h"
#include "tests/support/places.h"

namespace tact::fuzz::found_test {

TEST_CASE("fuzzed readers: seeds hold the laws, and so do accidents of them" *
          doctest::test_suite("long")) {
    std::mt19937 random(14);
    for (const Reader& reader : all_readers()) {
        bool accepted = false;
        for (const std::string& seed : reader.seeds()) {
            accepted |= reader.read(seed);
            for (int turn = 0; turn < 500; ++turn) reader.read(after_mishaps(seed, random));
        }
        CHECK_MESSAGE(accepted, std::string(reader.name));
    }
}

TEST_CASE("fuzzed readers: what once broke one is read") {
    const std::filesystem::path found =
        std::filesystem::path(kGoldenDir).parent_path() / "fuzz/found";
    std::set<std::string> names;
    for (const Reader& reader : all_readers()) {
        names.insert(reader.name);
        if (!std::filesystem::exists(found / reader.name)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(found / reader.name)) {
            std::ifstream file(entry.path(), std::ios::binary);
            reader.read(std::string{std::istreambuf_iterator<char>(file), {}});
        }
    }
    if (!std::filesystem::exists(found)) return;
    for (const auto& entry : std::filesystem::directory_iterator(found)) {
        CHECK_MESSAGE(names.contains(entry.path().filename().string()), entry.path());
    }
}

}  // namespace tact::fuzz::found_test
