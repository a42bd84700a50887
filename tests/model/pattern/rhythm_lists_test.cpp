#include "model/pattern/rhythm.h"

#include <algorithm>
#include <set>

#include "tests/support/golden.h"

namespace rhythm_lists_test {

using namespace tact;

namespace {

std::pair<std::size_t, std::size_t> steps_and_notes(const std::string& key) {
    const std::size_t comma = key.find(',');
    return {std::stoul(key.substr(0, comma)), std::stoul(key.substr(comma + 1))};
}

}  // namespace

TEST_CASE("necklaces: exactly those that enumeration finds") {
    const golden::Json all = golden::read("design.json", "necklaces");
    for (const auto& [key, expected] : all.items()) {
        const auto [steps, notes] = steps_and_notes(key);
        CHECK_MESSAGE(necklaces(steps, notes) == expected.get<std::vector<std::string>>(), key);
        CHECK_MESSAGE(necklace_count(steps, notes) == expected.size(), key);
    }
}

TEST_CASE("necklaces: long ones are as many as counting and Burnside say") {
    const golden::Json all = golden::read("design.json", "counts");
    for (const auto& [key, expected] : all.items()) {
        const auto [steps, notes] = steps_and_notes(key);
        CHECK_MESSAGE(necklace_count(steps, notes) == expected.get<std::uint64_t>(), key);
        CHECK_MESSAGE(necklaces(steps, notes).size() == expected.get<std::size_t>(), key);
    }
}

TEST_CASE("necklaces: all binary ones together are the numbers of OEIS A000031") {
    const std::uint64_t known[] = {2, 3, 4, 6, 8, 14, 20, 36, 60, 108, 188, 352};
    for (std::size_t steps = 1; steps <= std::size(known); ++steps) {
        std::uint64_t all = 0;
        for (std::size_t notes = 0; notes <= steps; ++notes) all += necklace_count(steps, notes);
        CHECK(all == known[steps - 1]);
    }
    CHECK(necklace_count(kMostListSteps, 12) == 112'720);
}

TEST_CASE("necklaces: what makes no rhythm makes an empty list") {
    CHECK(necklaces(0, 0).empty());
    CHECK(necklaces(4, 0).empty());
    CHECK(necklaces(4, 5).empty());
    CHECK(necklaces(kMostListSteps + 1, 1).empty());
    CHECK(necklaces(4, 4) == std::vector<std::string>{"xxxx"});
}

TEST_CASE("euclidean rhythms: those that Toussaint found in the world's music") {
    const std::pair<const char*, std::size_t> known[] = {{"x-x", 2},
                                                         {"x-x--", 2},
                                                         {"x--", 1},
                                                         {"x-xx", 3},
                                                         {"x-x-x", 3},
                                                         {"x-x-x--", 3},
                                                         {"x--x--x-", 3},
                                                         {"x-x-x-x", 4},
                                                         {"x-x-x-x--", 4},
                                                         {"x--x--x--x-", 4},
                                                         {"x-xxxx", 5},
                                                         {"x-xx-xx", 5},
                                                         {"x-xx-xx-", 5},
                                                         {"x-x-x-x-x", 5},
                                                         {"x-x-x-x-x--", 5},
                                                         {"x--x-x--x-x-", 5},
                                                         {"x--x--x--x--x---", 5},
                                                         {"x-xxxxxx", 7},
                                                         {"x-xx-x-xx-x-", 7},
                                                         {"x--x-x-x--x-x-x-", 7},
                                                         {"x-xx-x-x-xx-x-x-", 9},
                                                         {"x--x-x-x-x-x--x-x-x-x-x-", 11},
                                                         {"x-xx-x-x-x-x-xx-x-x-x-x-", 13}};
    for (const auto& [text, notes] : known) {
        CHECK(euclidean_rhythm(std::string(text).size(), notes) == text);
    }
    CHECK(euclidean_rhythm(4, 4) == "xxxx");
    CHECK(euclidean_rhythm(4, 0).empty());
    CHECK(euclidean_rhythm(4, 5).empty());
}

TEST_CASE("euclidean rhythms: no necklace of their size is more even") {
    for (const auto& [steps, notes] : {std::pair{8UL, 3UL}, {9UL, 4UL}, {12UL, 5UL}, {16UL, 6UL}}) {
        const double best = evenness(euclidean_rhythm(steps, notes));
        for (const std::string& text : necklaces(steps, notes)) {
            CHECK(evenness(text) <= best + 1e-12);
        }
    }
}

TEST_CASE("note length: notes are held as long as asked for, and never into the next") {
    CHECK(with_note_length("x--x-x--", 1) == "x--x-x--");
    CHECK(with_note_length("x--x-x--", 2) == "x=-x=x=-");
    CHECK(with_note_length("x--x-x--", 9) == "x==x=x==");
    CHECK(with_note_length("x--x-x--", 0) == "x==x=x==");
    CHECK(with_note_length("x==-", 1) == "x---");
    CHECK(with_note_length("--x-", 2) == "--x=");
    CHECK(with_note_length("", 2).empty());
    CHECK(with_note_length("----", 0) == "----");
}

}  // namespace rhythm_lists_test
