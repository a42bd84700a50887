// Notes are notes: a rhythm of n notes is n notes in every format that can hold them, each as loud
// as it was, and silent between. A format that cannot hold that many says so.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/export/exported_set.h"
#include "model/io/set/set_file.h"
#include "model/pattern/rhythm_edit.h"

namespace notes_kept_test {

using namespace tact;

namespace {

constexpr double kStepS = 0.030;
constexpr double kNoteS = 0.015;

double level_of(int note) { return 0.6 + 0.1 * (note % 5); }

// As an effect file's reader draws it: a jump up and a jump down for each note.
Pattern rhythm_of(int notes) {
    Pattern pattern;
    pattern.amplitude_g = 0.4;
    pattern.carriers.front().frequency_hz = 165.0;  // timings are read at it
    pattern.duration_s = notes * kStepS;
    pattern.amplitude_curve = {{0.0, level_of(0)}};
    for (int note = 0; note < notes; ++note) {
        const double start_s = note * kStepS;
        if (note > 0) {
            pattern.amplitude_curve.push_back({start_s, 0.0});
            pattern.amplitude_curve.push_back({start_s, level_of(note)});
        }
        pattern.amplitude_curve.push_back({start_s + kNoteS, level_of(note)});
        pattern.amplitude_curve.push_back({start_s + kNoteS, 0.0});
    }
    pattern.amplitude_curve.push_back({pattern.duration_s, 0.0});
    return pattern;
}

PatternSet set_of(const Pattern& pattern) {
    PatternSet set;
    Vibration vibration;
    vibration.name = "rhythm";
    vibration.source = pattern;
    set.vibrations.push_back(vibration);
    return set;
}

// What comes back, over time; of samples the largest within half a period.
double level_g(const VibrationSource& back, double t_s) {
    if (const auto* pattern = std::get_if<Pattern>(&back)) {
        return pattern->amplitude_g * amplitude_factor(*pattern, t_s);
    }
    const Waveform& waveform = *std::get<Measurement>(back).waveform;
    double largest = 0.0;
    for (double since_s = -0.0033; since_s <= 0.0033; since_s += 1e-5) {
        const auto n = static_cast<std::size_t>((t_s + since_s) * waveform.rate_hz);
        if (n < waveform.samples_g.size()) {
            largest = std::max(largest, std::abs(waveform.samples_g[n]));
        }
    }
    return largest;
}

struct Kept {
    int notes = 0;
    int gaps = 0;
};

// Notes as loud beside the first one as they were, within 1 %; gaps within 1 % of silence.
Kept kept_of(const VibrationSource& back, int notes) {
    Kept kept;
    const double first_g = level_g(back, 0.5 * kNoteS);
    for (int note = 0; note < notes; ++note) {
        const double meant_g = first_g * level_of(note) / level_of(0);
        const double got_g = level_g(back, note * kStepS + 0.5 * kNoteS);
        if (std::abs(got_g - meant_g) <= 0.01 * meant_g) ++kept.notes;
        const double gap_g = level_g(back, note * kStepS + kNoteS + 0.5 * (kStepS - kNoteS));
        if (gap_g <= 0.01 * first_g) ++kept.gaps;
    }
    return kept;
}

// It has no amplitude, so that notes have no level (tests/model/io/effects_out/on_off_test).
bool is_on_off(TargetFormat format) { return format == TargetFormat::web; }

// Whose own limits are lower: 16 points of some events, 500 points in all.
bool is_limited(TargetFormat format) {
    return format == TargetFormat::he || format == TargetFormat::openxr;
}

bool says_thinned(const ExportedPattern& made) {
    return std::ranges::any_of(made.remarks, [](const std::string& remark) {
        return remark.find("thinned") != std::string::npos;
    });
}

}  // namespace

TEST_CASE("notes: every note and every gap is in each file that can hold it" *
          doctest::test_suite("long")) {
    for (const int notes : {60, 126, 210, 2000}) {
        const Pattern pattern = rhythm_of(notes);
        for (const TargetTraits& format : target_formats()) {
            CAPTURE(notes);
            CAPTURE(std::string(format.key));
            ExportTarget target = own_target(*target_format_of(format.key));
            if (is_on_off(target.format)) continue;
            target = with_full_scale(target, set_of(pattern));
            const ExportedPattern made = exported(pattern, "rhythm", target);
            const Kept kept = kept_of(made.back, notes);
            const bool is_whole = kept.notes == notes && kept.gaps == notes;
            CAPTURE(kept.notes);
            CAPTURE(kept.gaps);
            CHECK(is_whole != says_thinned(made));
            if (!is_limited(target.format) || notes < 126) CHECK(is_whole);
            if (is_limited(target.format) && notes == 2000) CHECK_FALSE(is_whole);
        }
    }
}

TEST_CASE(
    "notes: AHAP and HJIF give back the notes of random rhythms, with strengths and pitches") {
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round) {
        Pattern pattern;
        pattern.amplitude_g = 0.4;
        pattern.carriers.front().frequency_hz = 120.0;
        pattern.rhythm.unit_s = 0.005 * static_cast<double>(2 + random() % 20);
        pattern.rhythm.kinds = {{'A', {0.5, 1.0}}, {'B', {1.0, 1.5}}, {'C', {0.8, 0.75}}};
        std::string& text = pattern.rhythm.text;
        text = "x";
        while (text.size() < 24) {
            const char mark = "x5ABC-=="[random() % 8];
            text += mark == '=' && text.back() == '-' ? '-' : mark;
        }
        text.back() = '-';
        pattern.duration_s = length_s(pattern.rhythm);
        const std::vector<Note> meant = notes(pattern.rhythm, pattern.duration_s);
        for (const TargetFormat format : {TargetFormat::ahap, TargetFormat::hjif}) {
            CAPTURE(text);
            CAPTURE(std::string(traits(format).key));
            const ExportedPattern made = exported(pattern, "rhythm", own_target(format));
            const auto found = with_found_notes(std::get<Pattern>(made.back));
            REQUIRE(found);
            std::vector<Note> got = notes(found->rhythm, found->duration_s);
            // Neighbours of one strength and pitch are one note there.
            std::vector<Note> joined;
            for (const Note& note : meant) {
                const bool touches =
                    !joined.empty() && joined.back().velocity == note.velocity &&
                    joined.back().pitch == note.pitch &&
                    std::abs(joined.back().onset_s + joined.back().length_s - note.onset_s) < 1e-9;
                if (touches) {
                    joined.back().length_s += note.length_s;
                } else {
                    joined.push_back(note);
                }
            }
            REQUIRE(got.size() == joined.size());
            for (std::size_t k = 0; k < got.size(); ++k) {
                CHECK(std::abs(got[k].onset_s - joined[k].onset_s) < 1e-9);
                CHECK(std::abs(got[k].length_s - joined[k].length_s) < 1e-9);
                CHECK(std::abs(got[k].velocity * found->amplitude_g -
                               joined[k].velocity * pattern.amplitude_g) <
                      0.01 * joined[k].velocity * pattern.amplitude_g);
                CHECK(std::abs(got[k].pitch * found->carriers[0].frequency_hz -
                               joined[k].pitch * 120.0) < 0.01 * joined[k].pitch * 120.0);
            }
        }
    }
}

TEST_CASE("notes: a set file keeps them as they are") {
    for (const int notes : {126, 210, 2000}) {
        const PatternSet set = set_of(rhythm_of(notes));
        const auto read = parse_set(print_set(set), "rhythm", {});
        REQUIRE(read);
        CHECK(std::get<Pattern>(read->vibrations.front().source) ==
              std::get<Pattern>(set.vibrations.front().source));
    }
}

}  // namespace notes_kept_test
