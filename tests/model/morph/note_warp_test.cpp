#include "model/morph/note_warp.h"

#include <doctest/doctest.h>

namespace note_warp_test {

using namespace tact;

namespace {

constexpr double kUnitS = 0.125;

std::vector<Note> notes_of(const char* text) { return notes({text, kUnitS}, 1.0); }

std::vector<WarpedNote> warp(const char* from, const char* to) {
    return *warped_notes(notes_of(from), 1.0, notes_of(to), 1.0);
}

}  // namespace

TEST_CASE("note warp: a note that stays is one note, a note elsewhere moves there") {
    const auto same = warp("x=--x---", "x=--x---");
    REQUIRE(same.size() == 2);
    for (const WarpedNote& note : same) {
        CHECK(note.from.begin_s == note.to.begin_s);
        CHECK(note.from.end_s == note.to.end_s);
    }
    const auto moved = warp("x-------", "------x-");
    REQUIRE(moved.size() == 1);
    CHECK(moved[0].from.begin_s == 0.0);
    CHECK(moved[0].to.begin_s == doctest::Approx(0.75));
    CHECK(moved[0].from.whole);
    CHECK(moved[0].to.whole);
}

TEST_CASE("note warp: one long note splits into many, which fill it without a gap") {
    const auto split = warp("x=======", "x-x-x-x-");
    REQUIRE(split.size() == 4);
    CHECK(split.front().from.begin_s == 0.0);
    CHECK(split.back().from.end_s == doctest::Approx(1.0));
    for (std::size_t k = 1; k < split.size(); ++k) {
        CHECK(split[k].from.begin_s == doctest::Approx(split[k - 1].from.end_s));
    }
    const auto melted = warp("x-x-x-x-", "x=======");
    REQUIRE(melted.size() == 4);
    CHECK(melted[2].from.begin_s == doctest::Approx(0.5));
    CHECK(melted[2].to.begin_s == doctest::Approx(split[2].from.begin_s));
}

TEST_CASE("note warp: notes that the other has not fade where they would be, in one direction") {
    const auto faded = warp("x-x-x-x-", "x---x---");
    REQUIRE(faded.size() == 4);
    std::size_t fading = 0;
    for (const WarpedNote& note : faded) {
        REQUIRE(note.from.whole);  // nothing comes while others go
        if (note.to.whole) continue;
        ++fading;
        CHECK(note.to.begin_s == doctest::Approx(note.from.begin_s));
    }
    CHECK(fading == 2);
    const auto silence = warp("x-x-", "----");
    CHECK(silence.size() == 4);  // the text repeats
    CHECK(warp("----", "----").empty());
}

TEST_CASE("note warp: notes keep their order on every part of the way") {
    for (const char* to : {"--x=-x-x", "xxxxxxxx", "x=======", "-x--x--x", "x-------"}) {
        const auto all = warp("x--x-x==", to);
        for (const double share : {0.1, 0.5, 0.9}) {
            double end_s = 0.0;
            for (const WarpedNote& note : all) {
                const auto at = [share](double a, double b) { return a + share * (b - a); };
                const double begin_s = at(note.from.begin_s, note.to.begin_s);
                CHECK(begin_s >= end_s - 1e-12);
                end_s = at(note.from.end_s, note.to.end_s);
                CHECK(end_s >= begin_s);
            }
            CHECK(end_s <= 1.0 + 1e-12);
        }
    }
}

TEST_CASE("note warp: too many notes are told") {
    const std::vector<Note> many = notes({"x-", 0.001}, 1.0);
    CHECK_FALSE(warped_notes(many, 1.0, notes_of("x---"), 1.0));
}

}  // namespace note_warp_test
