#include "model/pattern/rhythm.h"

#include "model/pattern/pattern.h"
#include "model/pattern/same_vibration.h"
#include "tests/support/golden.h"

namespace rhythm_test {

using namespace tact;

TEST_CASE("rhythm: x starts a note, = holds it, - rests") {
    const auto found = notes({"x=x---x-", 0.125}, 1.0);
    CHECK(found == std::vector<Note>{{0.0, 0.25}, {0.25, 0.125}, {0.75, 0.125}});
}

TEST_CASE("rhythm: no text is one note throughout") {
    CHECK(notes({}, 2.5) == std::vector<Note>{{0.0, 2.5}});
}

TEST_CASE("rhythm: the text repeats to fill the duration, and the last note is cut there") {
    const auto found = notes({"x=-", 0.25}, 1.0);
    CHECK(found == std::vector<Note>{{0.0, 0.5}, {0.75, 0.25}});
}

TEST_CASE("rhythm: all rests are no notes") { CHECK(notes({"----", 0.1}, 1.0).empty()); }

TEST_CASE("rhythm: text that is none is named with the step at fault") {
    CHECK(rhythm_fault("x=x---x-").empty());
    CHECK(rhythm_fault("").empty());
    CHECK(rhythm_fault("xqx") == "step 2 is not one of x, 1 to 9, A to Z, = and -");
    CHECK(rhythm_fault("=x") == "step 1 is =, which must follow x or =");
    CHECK(rhythm_fault("x-=") == "step 3 is =, which must follow x or =");
    CHECK(rhythm_fault(std::string(20'000, 'x')).empty());
    CHECK(rhythm_fault(std::string(20'001, 'x')) == "it has 20,001 steps, expected at most 20,000");
}

TEST_CASE("rhythm: a digit starts a note of so many ninths, and nothing else differs") {
    CHECK(notes({"x=9-5=1", 0.1}, 0.7) == std::vector<Note>{{0.0, 0.2, 1.0},
                                                            {0.2, 3 * 0.1 - 0.2, 1.0},
                                                            {0.4, 6 * 0.1 - 0.4, 5.0 / 9.0},
                                                            {6 * 0.1, 0.7 - 6 * 0.1, 1.0 / 9.0}});
    CHECK(rhythm_fault("5=-1").empty());
    CHECK(rhythm_fault("x0") == "step 2 is not one of x, 1 to 9, A to Z, = and -");
    CHECK(note_at({"3=x", 0.1}, 0.3, 0.15)->velocity == 3.0 / 9.0);
    CHECK(onsets("3=x-9") == std::vector<std::size_t>{0, 2, 4});
    CHECK(evenness("3--9--x-") == evenness("x--x--x-"));
    CHECK(with_note("3---", 0, 2) == "3==-");
    for (const char mark : std::string("12345678x")) {
        CHECK(note_mark(kind_of({}, mark).velocity) == mark);
    }
    CHECK(note_mark(kind_of({}, '9').velocity) == 'x');
    CHECK(note_mark(0.0) == '1');
    // A note is so much weaker, sample by sample, with its ramps; the whole strength is the same
    // bits.
    Pattern pattern;
    pattern.attack_s = 0.02;
    pattern.release_s = 0.01;
    pattern.rhythm = {"x=-x=---", 0.125};
    const std::vector<double> whole = render(pattern).samples_g;
    pattern.rhythm.text = "9=-9=---";
    CHECK(render(pattern).samples_g == whole);
    pattern.rhythm.text = "4=-9=---";
    const std::vector<double> weaker = render(pattern).samples_g;
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const double factor = n < 3750 ? 4.0 / 9.0 : 1.0;
        REQUIRE(std::abs(weaker[n] - factor * whole[n]) < 1e-15);
    }
    CHECK(envelope_g(pattern, 0.1) == doctest::Approx(4.0 / 9.0));
}

TEST_CASE(
    "rhythm: notes of several strengths and pitches are the samples of an independent rendering") {
    for (const golden::Json& row : golden::read("notes.json", "notes")) {
        CAPTURE(row.at("rhythm").dump());
        Pattern pattern;
        pattern.carriers = {{150.0, 1.0, 0.0}, {220.0, 0.5, 0.0}};
        pattern.rhythm = {row.at("rhythm"), row.at("unit_s")};
        for (const auto& [letter, kind] : row.at("kinds").items()) {
            pattern.rhythm.kinds[letter[0]] = {kind[0], kind[1]};
        }
        pattern.attack_s = row.at("attack_s");
        pattern.release_s = row.at("release_s");
        pattern.duration_s = row.at("duration_s");
        const std::vector<double> samples = render(pattern).samples_g;
        REQUIRE(samples.size() == row.at("samples").get<std::size_t>());
        const std::vector<double> expected = row.at("every_61st");
        double squares = 0.0;
        for (const double sample : samples) squares += sample * sample;
        CHECK(squares == doctest::Approx(row.at("squares").get<double>()).epsilon(1e-9));
        for (std::size_t k = 0; k < expected.size(); ++k) {
            CHECK(std::abs(samples[61 * k] - expected[k]) < 1e-9);
        }
    }
}

TEST_CASE("rhythm: a letter is a note of its kind, and without one the whole note") {
    const Rhythm rhythm{"A=B-", 0.1, {{'A', {0.37, 1.5}}}};
    const std::vector<Note> all = notes(rhythm, 0.8);
    REQUIRE(all.size() == 4);
    CHECK(all[0] == Note{0.0, 0.2, 0.37, 1.5});
    CHECK(all[1].velocity == 1.0);
    CHECK(all[1].pitch == 1.0);
    CHECK(all[2].pitch == 1.5);  // as the text repeats
    CHECK(note_at(rhythm, 0.8, 0.15) == all[0]);
    CHECK(pitch_at(rhythm, 0.15) == 1.5);
    CHECK(pitch_at(rhythm, 0.39) == 1.0);
    CHECK(pitch_at({"--A-", 0.1, rhythm.kinds}, 0.0) == 1.5);
    CHECK(has_pitches(rhythm));
    CHECK_FALSE(has_pitches({"x=5-", 0.1, rhythm.kinds}));
}

TEST_CASE("rhythm: a mark is a digit where that is exact, a known kind, or the first free letter") {
    Rhythm rhythm{"xA--", 0.1, {{'A', {0.37, 1.0}}}};
    CHECK(mark_for(rhythm, {4.0 / 9.0, 1.0}) == '4');
    CHECK(mark_for(rhythm, {0.37, 1.0}) == 'A');
    CHECK(mark_for(rhythm, {0.37, 2.0}) == 'B');
    CHECK(kind_of(rhythm, 'B') == NoteKind{0.37, 2.0});
    rhythm.text = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    CHECK_FALSE(mark_for(rhythm, {0.123, 1.0}));
}

TEST_CASE("rhythm: another rhythm's letters mean in this one what they mean there") {
    Rhythm rhythm{"A-", 0.1, {{'A', {0.5, 1.0}}}};
    const Rhythm other{"AB=A", 0.1, {{'A', {1.0, 2.0}}, {'B', {0.5, 1.0}}}};
    const auto text = text_with_kinds_of(rhythm, other);
    REQUIRE(text);
    CHECK(*text == "BA=B");
    for (std::size_t k = 0; k < text->size(); ++k) {
        if (!starts_note((*text)[k])) continue;
        CHECK(kind_of(rhythm, (*text)[k]) == kind_of(other, other.text[k]));
    }
    CHECK(kind_of(rhythm, 'A') == NoteKind{0.5, 1.0});
}

TEST_CASE("rhythm: pitches in the frequency curve are the same vibration") {
    Pattern pattern;
    pattern.carriers = {{120.0, 1.0, 0.3}, {200.0, 0.5, 0.0}};
    pattern.rhythm = {"A=B-xA--", 0.07, {{'A', {0.6, 1.7}}, {'B', {1.0, 0.4}}}};
    pattern.release_s = 0.01;
    for (const bool drawn : {false, true}) {
        if (drawn)
            pattern.frequency_curve = {{0.1, 100.0}, {0.28, 240.0}, {0.28, 80.0}, {0.9, 90.0}};
        const Pattern curve = with_drawn_pitches(pattern);
        CHECK_FALSE(has_pitches(curve.rhythm));
        CHECK(render(curve).samples_g == render(pattern).samples_g);
        CHECK(essence(curve) == essence(pattern));
        for (int ms = 0; ms < 1000; ++ms) {
            // Half a ms from where notes begin, as those are products.
            const double t_s = 0.001 * ms + 0.0005;
            CHECK(first_carrier_hz(curve, t_s) ==
                  doctest::Approx(first_carrier_hz(pattern, t_s)).epsilon(1e-9));
        }
    }
    // A pitch of 1 changes no bit.
    pattern.frequency_curve.clear();
    pattern.rhythm.kinds = {{'A', {0.6, 1.0}}};
    CHECK(sounding_frequency(pattern).empty());
}

TEST_CASE("rhythm: evenness is that of the Fourier transform of its onsets") {
    const golden::Json all = golden::read("design.json", "evenness");
    for (const auto& [text, expected] : all.items()) {
        CHECK_MESSAGE(std::abs(evenness(text) - expected.get<double>()) < 1e-14, text);
    }
    CHECK(evenness("") == 0.0);
    CHECK(evenness("----") == 0.0);
}

TEST_CASE("rhythm: evenness is 1 of equal gaps, whatever the notes' lengths and the rotation") {
    for (const char* text : {"x---", "x-x-", "-x-x", "x=-x=-", "xxxx"}) {
        CHECK(std::abs(evenness(text) - 1.0) < 1e-15);
    }
    CHECK(std::abs(evenness("x--x--x-") - evenness("-x--x--x")) < 1e-15);
    CHECK(evenness("xxx-----") < evenness("xx-x----"));
}

TEST_CASE("rhythm: a note drawn from one step to another replaces what was there") {
    CHECK(with_note("--------", 2, 4) == "--x==---");
    CHECK(with_note("x=x=x=--", 2, 2) == "x=x-x=--");
    CHECK(with_note("x===----", 1, 2) == "xx=-----");
    CHECK(with_note("x-x=-x=-", 1, 5) == "xx====--");
    CHECK(onsets("-x=xx-") == std::vector<std::size_t>{1, 3, 4});
}

TEST_CASE("rhythm: the note at a time is the one of the list that holds it") {
    for (const char* text : {"", "x", "x-", "x=-xx=", "--x", "-"}) {
        // 0.147 / 0.003 is less than 49, and 49 x 0.003 is 0.147.
        for (const double unit_s : {0.1, 0.07, 0.003, 1.0 / 3.0}) {
            const Rhythm rhythm{text, unit_s};
            const auto list = notes(rhythm, 1.3);
            for (int n = -10; n < 1400; ++n) {
                const double t = n / 1000.0;
                std::optional<Note> expected;
                for (std::size_t k = 0; k < list.size(); ++k) {
                    const bool last = k + 1 == list.size();
                    const double end_s = list[k].onset_s + list[k].length_s;
                    const bool ended = t >= end_s || (!last && t >= list[k + 1].onset_s);
                    if (t >= list[k].onset_s && !ended) expected = list[k];
                }
                const auto got = note_at(rhythm, 1.3, t);
                REQUIRE(got.has_value() == expected.has_value());
                if (!got) continue;
                CHECK(got->onset_s == expected->onset_s);
                CHECK(got->length_s == expected->length_s);
            }
        }
    }
}

}  // namespace rhythm_test
