// What is said of numbers is the same in every form, and comes back from a table's corner.

#include "model/dissimilarity/number_mark.h"

#include <doctest/doctest.h>

namespace number_mark_test {

using namespace tact;

namespace {

// By its bits, so that every combination is tried.
NumberMark mark_of_bits(unsigned bits) {
    NumberMark mark{(bits & 1U) != 0, (bits & 2U) != 0,  (bits & 4U) != 0,
                    (bits & 8U) != 0, (bits & 16U) != 0, (bits & 32U) != 0};
    if ((bits & 64U) != 0) mark.left_out = 12;
    if ((bits & 192U) == 192U) mark.rehearsals = 3;
    return mark;
}

}  // namespace

TEST_CASE("number marks: a corner of a table says all of it, and is read back equal") {
    for (unsigned bits = 0; bits < 256; ++bits) {
        const NumberMark mark = mark_of_bits(bits);
        CHECK(mark_in(corner_text(mark)) == mark);
        CHECK((corner_text(mark).empty() == (mark == NumberMark{})));
        CHECK((phrase_of(mark).empty() == (mark == NumberMark{})));
    }
}

TEST_CASE("number marks: of two, both are kept, in any order") {
    for (unsigned a = 0; a < 256; ++a) {
        for (unsigned b = 0; b < 256; b += 5) {
            const NumberMark both = mark_of_bits(a) | mark_of_bits(b);
            CHECK(both == (mark_of_bits(b) | mark_of_bits(a)));
            CHECK((both | mark_of_bits(a)) == both);
        }
    }
}

TEST_CASE("number marks: corners that earlier versions wrote are understood") {
    CHECK(mark_in("SYNTHETIC: nobody was asked for some or all of these").synthetic);
    CHECK(mark_in("SYNTHETIC: the model was fitted to ratings that nobody gave") ==
          NumberMark{.synthetic_model = true});
    CHECK(mark_in("CHANGED: some or all of these patterns are others than those that were felt; "
                  "1 pattern was edited since it was rated: \"a\"") == NumberMark{.stale = true});
    for (const char* heading : {"", "name", "synthetic", "EXCLUDED: people"}) {
        CHECK(mark_in(heading) == NumberMark{});
    }
}

}  // namespace number_mark_test
