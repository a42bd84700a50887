// Notes chosen together, against what a hand would write, and laws over random rhythms.
#include "model/algebra/chosen_notes.h"

#include <doctest/doctest.h>

#include <random>

#include "model/pattern/drawn_fault.h"

namespace chosen_notes_test {

using namespace tact;

namespace {

// Steps of 1/8 s, exact in binary.
Pattern of_steps(const std::string& text, std::size_t steps) {
    Pattern pattern;
    pattern.rhythm = {text, 0.125};
    pattern.duration_s = 0.125 * static_cast<double>(steps);
    return pattern;
}

const std::string& text_of(const Expected<NotesEdit>& edit) { return edit->pattern.rhythm.text; }

}  // namespace

TEST_CASE("chosen notes: a box has the notes that sound in it, and a copy has its rests") {
    const Pattern bar = of_steps("x=--5---", 8);
    const ChosenNotes chosen = notes_within(bar, {0, 7});
    CHECK(chosen.onsets == std::vector<std::size_t>{0, 4});
    CHECK(copied_notes(bar, chosen) == "x=--5---");
    CHECK(notes_within(bar, {1, 3}).onsets == std::vector<std::size_t>{0});
    CHECK(copied_notes(bar, notes_within(bar, {1, 3})) == "x=--");  // not cut at its start
    CHECK(notes_within(bar, {2, 3}).empty());
    CHECK(copied_notes(bar, with_toggled(bar, {}, 4)) == "5");
    CHECK(with_toggled(bar, chosen, 0).span == NoteSteps{4, 4});
}

TEST_CASE(
    "chosen notes: strength by a difference, pitch by a factor, and a kind follows its note") {
    const Pattern bar = of_steps("x=--5-x-", 8);
    const ChosenNotes two = with_toggled(bar, with_toggled(bar, {}, 0), 4);
    const auto high = with_notes_changed(bar, two, 0.0, 1.5);
    REQUIRE(high);
    CHECK(text_of(high) == "A=--B-x-");
    CHECK(kind_of(high->pattern.rhythm, 'A') == NoteKind{1.0, 1.5});
    CHECK(kind_of(high->pattern.rhythm, 'B') == NoteKind{5.0 / 9.0, 1.5});
    const auto back = with_notes_changed(high->pattern, high->chosen, 0.0, 1.0 / 1.5);
    CHECK(back->pattern == bar);
    const auto weak = with_notes_changed(bar, two, -0.1, 1.0);
    CHECK(kind_of(weak->pattern.rhythm, text_of(weak)[0]).velocity == doctest::Approx(0.9));
    // By ninths, a note keeps its pitch.
    const auto weaker = with_notes_stronger(high->pattern, two, -2);
    CHECK(kind_of(weaker->pattern.rhythm, text_of(weaker)[0]) == NoteKind{7.0 / 9.0, 1.5});
    const auto moved = with_notes_moved(high->pattern, high->chosen, 1);
    CHECK(text_of(moved) == "-A=--Bx-");
    // Again and again, as a slider does, it takes no more letters than it needs.
    NotesEdit edit = *high;
    for (int k = 0; k < 100; ++k)
        edit = *with_notes_changed(edit.pattern, edit.chosen, -0.001, 1.0);
    CHECK(edit.pattern.rhythm.kinds.size() == 2);
}

TEST_CASE("chosen notes: a bar four times is four bars long, each as the first") {
    const Pattern bar = of_steps("x=--5---", 8);
    const auto four = with_notes_repeated(bar, notes_within(bar, {0, 7}), 4);
    REQUIRE(four);
    CHECK(text_of(four) == "x=--5---x=--5---x=--5---x=--5---");
    CHECK(four->pattern.duration_s == 4.0);
    CHECK(four->chosen.onsets == std::vector<std::size_t>{24, 28});
    CHECK(four->chosen.span == NoteSteps{24, 31});
    // Notes alone end with the last of them: what follows comes right behind.
    CHECK(text_of(with_notes_repeated(bar, with_toggled(bar, {}, 0), 2)) == "x=x=5---");
}

TEST_CASE("chosen notes: what is pasted takes the place of what is there, and cuts what was held") {
    const Pattern long_note = of_steps("x======-", 8);
    CHECK(text_of(with_notes_pasted(long_note, 2, "-5")) == "x=-5----");
    const auto behind = with_notes_pasted(long_note, 9, "x=");
    CHECK(text_of(behind) == "x======--x=");
    CHECK(behind->pattern.duration_s == 11.0 * 0.125);
    CHECK(text_of(with_notes_pasted(of_steps("", 8), 3, "x=")) == "---x=-----------");
}

TEST_CASE("chosen notes: a repetition of the text is written out before it changes alone") {
    const Pattern twice = of_steps("x-5-", 8);
    CHECK(text_of(without_notes(twice, with_toggled(twice, {}, 6))) == "x-5-x---");
    CHECK(text_of(without_notes(twice, with_toggled(twice, {}, 2))) == "x---");
    CHECK(text_of(with_notes_pasted(twice, 5, "9")) == "x-5-x95-");
    CHECK(text_of(with_notes_stronger(twice, notes_within(twice, {4, 7}), -2)) == "x-5-7-3-");
}

TEST_CASE("chosen notes: they move together, as far as the text, over what is in their way") {
    const Pattern bar = of_steps("x=-5--7=", 8);
    const ChosenNotes two = with_toggled(bar, with_toggled(bar, {}, 0), 3);
    CHECK(text_of(with_notes_moved(bar, two, 1)) == "-x=-5-7=");
    const auto far = with_notes_moved(bar, two, 9);
    CHECK(text_of(far) == "----x=75");
    CHECK(far->chosen.onsets == std::vector<std::size_t>{4, 7});
    CHECK(text_of(with_notes_moved(bar, two, -3)) == bar.rhythm.text);
}

TEST_CASE("chosen notes: strengths keep their differences, and lengths end at the next note") {
    const Pattern bar = of_steps("x-3-5---", 8);
    const ChosenNotes all = notes_within(bar, {0, 7});
    CHECK(text_of(with_notes_stronger(bar, all, -4)) == "5-1-1---");
    CHECK(text_of(with_notes_stronger(bar, all, 2)) == "x-5-7---");
    CHECK(text_of(with_notes_held(bar, all, 3)) == "x=3=5==-");
    CHECK(text_of(with_notes_held(of_steps("x==-", 4), {{0}, {0, 2}}, 1)) == "x---");
}

TEST_CASE("chosen notes: what would be too long is refused in a sentence") {
    const Pattern bar = of_steps("x-------", 8);
    const auto long_one = with_notes_repeated(bar, notes_within(bar, {0, 7}), 61);
    REQUIRE_FALSE(long_one);
    CHECK(long_one.error().message ==
          "The pattern would become 61 s long; the longest lasts 60 s.");
    Pattern fine = of_steps("x-", 2);
    fine.rhythm.unit_s = 0.001;
    fine.duration_s = 30.0;
    const auto many = without_notes(fine, notes_within(fine, {2, 2}));
    REQUIRE_FALSE(many);
    CHECK(many.error().message == "A rhythm has at most 20,000 steps.");
}

TEST_CASE(
    "chosen notes: any edit of any choice leaves a pattern without fault that has its choice") {
    std::mt19937 random(7);
    for (int k = 0; k < 400; ++k) {
        std::string text;
        for (std::size_t step = 1 + random() % 12; step > 0; --step) {
            const bool holds = !text.empty() && text.back() != '-' && random() % 3 == 0;
            text += holds ? '=' : random() % 2 == 0 ? '-' : static_cast<char>('1' + random() % 9);
        }
        Pattern pattern = of_steps(text, 1 + random() % 30);
        if (random() % 2 == 0) pattern.duration_s *= 0.93;  // not a whole number of steps
        const std::size_t from = random() % 30;
        const ChosenNotes chosen = notes_within(pattern, {from, from + random() % 10});
        CHECK(kept_choice(pattern, chosen).onsets == chosen.onsets);
        const auto by = static_cast<std::ptrdiff_t>(random() % 40) - 20;
        for (const auto& edit :
             {with_notes_moved(pattern, chosen, by),
              with_notes_stronger(pattern, chosen, static_cast<int>(by) / 3),
              with_notes_held(pattern, chosen, 1 + random() % 6), without_notes(pattern, chosen),
              with_notes_repeated(pattern, chosen, 1 + static_cast<int>(random() % 4)),
              with_notes_pasted(pattern, random() % 40, "x=-5")}) {
            REQUIRE(edit);
            CAPTURE(text);
            CHECK(rhythm_fault(text_of(edit)).empty());
            CHECK(!drawn_fault(edit->pattern));
            CHECK(kept_choice(edit->pattern, edit->chosen).onsets == edit->chosen.onsets);
        }
    }
}

}  // namespace chosen_notes_test
