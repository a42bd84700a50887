#include "model/pattern/rhythm_edit.h"

#include <doctest/doctest.h>

#include "model/common/random.h"
#include "model/pattern/pattern.h"

namespace rhythm_edit_test {

using namespace tact;

TEST_CASE("rhythm edit: notes are found with their first and last steps") {
    CHECK(note_steps("x=-xx==-") == std::vector<NoteSteps>{{0, 1}, {3, 3}, {4, 6}});
    CHECK(note_steps("").empty());
    CHECK(note_steps("---").empty());
}

TEST_CASE("rhythm edit: an edge moves alone, a note as a whole") {
    CHECK(with_note_moved("-x=--x--", 0, NotePart::end, 1) == "-x==-x--");
    CHECK(with_note_moved("-x=--x--", 0, NotePart::end, -1) == "-x---x--");
    CHECK(with_note_moved("-x=--x--", 0, NotePart::start, -1) == "x==--x--");
    CHECK(with_note_moved("-x=--x--", 0, NotePart::start, 1) == "--x--x--");
    CHECK(with_note_moved("-x=--x--", 0, NotePart::whole, 2) == "---x=x--");
    CHECK(with_note_moved("-x=--x--", 1, NotePart::whole, -2) == "-x=x----");
    CHECK(with_note_moved("-x=--x--", 1, NotePart::whole, 0) == "-x=--x--");
}

TEST_CASE("rhythm edit: a note stops at its neighbours and at the ends, and keeps a step") {
    CHECK(with_note_moved("-x=-x---", 0, NotePart::end, 9) == "-x==x---");
    CHECK(with_note_moved("-x=-x---", 0, NotePart::end, -9) == "-x--x---");
    CHECK(with_note_moved("-x=-x---", 0, NotePart::start, -9) == "x==-x---");
    CHECK(with_note_moved("-x=-x---", 0, NotePart::start, 9) == "--x-x---");
    CHECK(with_note_moved("-x=-x---", 1, NotePart::start, -9) == "-x=x=---");
    CHECK(with_note_moved("-x=-x---", 1, NotePart::end, 9) == "-x=-x===");
    CHECK(with_note_moved("-x=-x---", 1, NotePart::whole, 9) == "-x=----x");
    CHECK(with_note_moved("xx", 0, NotePart::whole, 1) == "xx");
}

TEST_CASE("rhythm edit: a note that is taken away leaves rests") {
    CHECK(tempo_bpm(0.125, 4) == 120.0);
    CHECK(unit_at_tempo(120.0, 4) == 0.125);
    CHECK(tempo_bpm(0.125, 2) == 240.0);
    CHECK(steps_a_bar({3, 4}) == 12);
    CHECK(steps_a_bar({}) == 0);
    CHECK(with_step({4, 3}, 0.125, 0.0625) == Meter{8, 3});
    CHECK(with_step({4, 0}, 0.125, 0.25) == Meter{2, 0});
    CHECK(with_step({4, 0}, 0.125, 0.1) == Meter{5, 0});
    CHECK(with_step({4, 0}, 0.125, 0.11) == Meter{4, 0});         // no whole number of steps
    CHECK(with_step({8, 0}, 0.125, 0.125 / 4.0) == Meter{8, 0});  // more than a beat may have
    // A note keeps its strength wherever it goes.
    CHECK(with_note_moved("-4=-x---", 0, NotePart::whole, 1) == "--4=x---");
    CHECK(with_note_moved("-4=-x---", 0, NotePart::start, -1) == "4==-x---");
    CHECK(with_note_moved("-4=-x---", 0, NotePart::end, 1) == "-4==x---");
    CHECK(without_note("-x=-xx==", 0) == "----xx==");
    CHECK(without_note("-x=-xx==", 2) == "-x=-x---");
}

TEST_CASE("rhythm edit: whatever is moved wherever leaves as many notes and no fault") {
    RandomStream random{7};
    const auto below = [&](std::size_t n) { return next_index(random, n); };
    for (int run = 0; run < 300; ++run) {
        std::string text;
        const std::size_t length = 1 + below(20);
        for (std::size_t step = 0; step < length; ++step) {
            const char mark = "x=-"[below(3)];
            text += mark == '=' && (text.empty() || text.back() == '-') ? 'x' : mark;
        }
        const std::size_t count = note_steps(text).size();
        if (count == 0) continue;
        const auto part = static_cast<NotePart>(below(3));
        const long steps = static_cast<long>(below(60)) - 30;
        const std::string moved = with_note_moved(text, below(count), part, steps);
        CHECK(rhythm_fault(moved).empty());
        CHECK(moved.size() == text.size());
        CHECK(note_steps(moved).size() == count);
    }
}

TEST_CASE("rhythm edit: a finer or coarser grid is the same rhythm") {
    const Rhythm rhythm{"x=-x", 0.1};
    const Rhythm fine = refined(rhythm, 4);
    CHECK(fine.text == "x=======----x===");
    CHECK(fine.unit_s == doctest::Approx(0.025));
    CHECK(coarsened(fine, 4).text == rhythm.text);
    CHECK(coarsened(fine, 4).unit_s == doctest::Approx(0.1));
    CHECK(coarsened({"x=----x=", 0.1}, 4).text == "x--x");
    CHECK(coarsened({"x-----x=", 0.1}, 4).text == "x-----x=");  // a note of one step
    CHECK(coarsened({"xxxx", 0.1}, 4).text == "xxxx");
    CHECK(refined({std::string(10'000, 'x'), 0.1}, 4).text.size() == 10'000);
    CHECK(refined({"x", 0.002}, 4).unit_s == 0.002);
}

}  // namespace rhythm_edit_test
