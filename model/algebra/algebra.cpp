#include "model/algebra/algebra.h"

#include <algorithm>
#include <cmath>

#include "model/algebra/algebra_parts.h"
#include "model/pattern/drawn_fault.h"
#include "model/pattern/pattern_numbers.h"
#include "model/pattern/rhythm_edit.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

using enum EditNeeds;

// clang-format off
constexpr std::array<EditTraits, kEditKindCount> kEdits{{
    {"stretch", "Stretch", "times", number, {0.01, 100.0}, 2.0, "notes, ramps, curves, ticks and the duration last this many times as long; carriers, modulation and each tick keep their own time"},
    {"stretch-notes", "Stretch the notes", "times", number, {0.01, 100.0}, 2.0, "the rhythm's step and the ramps alone"},
    {"stretch-curves", "Stretch the curves", "times", number, {0.01, 100.0}, 2.0, "curves and the times of ticks alone; what comes to lie behind the end is cut"},
    {"reverse", "Reverse", "", nothing, {}, 0.0, "notes, ramps, curves and ticks from the end to the beginning"},
    {"repeat", "Repeat", "times", whole_number, {1.0, 1000.0}, 2.0, "this many times in a row"},
    {"join", "Join", "", pattern, {}, 0.0, "the other pattern behind this one; both need the same modulation and carriers, up to one factor of frequency"},
    {"mix", "Mix", "", pattern, {}, 0.0, "the other pattern at the same time: one pattern where carriers lie under the same notes and curves, or ticks over them; otherwise layers"},
    {"trim", "Trim silence", "", nothing, {}, 0.0, "without the silence at the beginning and at the end; of a recording, what is below 1 % of its peak"},
    {"fade-in", "Fade in", "s", number, {0.001, 60.0}, 0.2, "from nothing to full strength within this time"},
    {"fade-out", "Fade out", "s", number, {0.001, 60.0}, 0.2, "from full strength to nothing within this time before the end"},
    {"normalise", "Normalise to a peak", "g", number, {1e-6, 50.0}, 1.0, "so strong that the largest sample is this"},
    {"felt", "Normalise to a felt level", "dB", number, {-40.0, 80.0}, 20.0, "so strong that its strongest line is this far above the threshold of the receptors that feel it best"},
    {"quantise", "Quantise", "s", number, {0.001, 10.0}, 0.125, "starts and ends of notes, and ticks, to the nearest step of this grid; a note keeps one step"},
    {"quantise-bpm", "Quantise to a beat", "BPM", number, {1.0, 600.0}, 120.0, "the same to steps of this tempo, as many a beat as the rhythm counts (default: 4)"},
    {"transpose", "Transpose", "times", number, {0.01, 100.0}, 2.0, "frequencies of carriers, of the frequency curve and of ticks times this"},
    {"thin", "Thin the curves", "%", number, {0.0, 100.0}, 1.0, "as few points as keep amplitudes within this share of full scale, and frequencies within this share of the highest"},
    {"find-notes", "Find the notes", "", nothing, {}, 0.0, "curves that are flat between jumps as notes of a rhythm, each with its strength and pitch"}}};
// clang-format on

Expected<Pattern> with_other(Expected<Pattern> (*both)(Pattern, Pattern), Pattern pattern,
                             const VibrationSource& other) {
    const auto* second = std::get_if<Pattern>(&other);
    if (second == nullptr) return Error{"expected another pattern made of parameters"};
    return both(std::move(pattern), *second);
}

Expected<Pattern> applied(Pattern pattern, const Edit& edit, const PhysiologyTables& tables) {
    switch (edit.kind) {
        case EditKind::stretch:
            return stretched(std::move(pattern), edit.number, StretchOf::all);
        case EditKind::stretch_notes:
            return stretched(std::move(pattern), edit.number, StretchOf::notes);
        case EditKind::stretch_curves:
            return stretched(std::move(pattern), edit.number, StretchOf::curves);
        case EditKind::reverse:
            return reversed(std::move(pattern));
        case EditKind::repeat:
            return repeated(pattern, static_cast<int>(edit.number));
        case EditKind::join:
            return with_other(joined, std::move(pattern), *edit.other);
        case EditKind::mix:
            return with_other(mixed, std::move(pattern), *edit.other);
        case EditKind::trim:
            return trimmed(std::move(pattern));
        case EditKind::fade_in:
            return faded(std::move(pattern), edit.number, 0.0);
        case EditKind::fade_out:
            return faded(std::move(pattern), 0.0, edit.number);
        case EditKind::normalise:
            return normalised(std::move(pattern), edit.number);
        case EditKind::felt:
            return felt_at(std::move(pattern), edit.number, tables);
        case EditKind::quantise:
            return quantised(std::move(pattern), edit.number);
        case EditKind::quantise_bpm:
            return quantised(std::move(pattern),
                             unit_at_tempo(edit.number, pattern.rhythm.meter.steps_a_beat));
        case EditKind::transpose:
            return transposed(std::move(pattern), edit.number);
        case EditKind::thin:
            return thinned_curves(std::move(pattern), edit.number);
        case EditKind::find_notes:
            return notes_found(pattern);
    }
    return Error{"expected an edit"};
}

// The first thing that a file would refuse of the result, as the end of a sentence; empty: none.
std::string fault_of_result(const Pattern& pattern) {
    std::string fault;
    const auto look = [&fault](const char* what, const Number& number, double value,
                               const char* unit) {
        if (!fault.empty() || number.range.contains(value)) return;
        fault = "expected " + range_words(number.range, what) + unit + ", got " +
                shortest_digits(value) + unit;
    };
    look("a duration", numbers::kDuration, pattern.duration_s, " s");
    look("an amplitude", numbers::kAmplitude, pattern.amplitude_g, " g");
    if (!pattern.rhythm.text.empty()) {
        look("a step of the rhythm", numbers::kRhythmUnit, pattern.rhythm.unit_s, " s");
    }
    for (const Carrier& carrier : pattern.carriers) {
        look("a carrier", numbers::kCarrier, carrier.frequency_hz, " Hz");
        look("a weight", numbers::kWeight, carrier.weight, "");
    }
    look("a ramp", numbers::kAttack, pattern.attack_s, " s");
    look("a ramp", numbers::kRelease, pattern.release_s, " s");
    if (!fault.empty()) return fault;
    const auto drawn = drawn_fault(pattern);
    return drawn ? sentence(*drawn) : std::string();
}

}  // namespace

const EditTraits& traits(EditKind kind) { return kEdits[static_cast<std::size_t>(kind)]; }

std::optional<EditKind> edit_kind(std::string_view key) {
    for (std::size_t k = 0; k < kEdits.size(); ++k) {
        if (kEdits[k].key == key) return static_cast<EditKind>(k);
    }
    return std::nullopt;
}

std::string fault_of(const Edit& edit) {
    const EditTraits& about = traits(edit.kind);
    if (about.needs == nothing) return {};
    const std::string begin = std::string(about.key) + ": expected ";
    if (about.needs == pattern) return edit.other ? std::string() : begin + "another pattern";
    const bool whole = about.needs == whole_number;
    if (about.range.contains(edit.number) && (!whole || std::floor(edit.number) == edit.number)) {
        return {};
    }
    return begin + (whole ? "a whole number from " : "a number from ") +
           shortest_digits(about.range.low) + " to " + shortest_digits(about.range.high) +
           ", got " + shortest_digits(edit.number);
}

Expected<Pattern> edited(Pattern pattern, std::span<const Edit> edits,
                         const PhysiologyTables& tables) {
    for (const Edit& edit : edits) {
        if (const std::string fault = fault_of(edit); !fault.empty()) return Error{fault};
        const std::string begin = std::string(traits(edit.kind).key) + ": ";
        Expected<Pattern> next = applied(std::move(pattern), edit, tables);
        if (!next) return Error{begin + next.error().message};
        if (const std::string fault = fault_of_result(*next); !fault.empty()) {
            return Error{begin + fault};
        }
        pattern = *std::move(next);
    }
    return pattern;
}

}  // namespace tact
