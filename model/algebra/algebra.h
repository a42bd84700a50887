// Patterns made of patterns: stretched, reversed, repeated, joined, mixed, trimmed, faded,
// levelled, put on a grid, transposed, thinned.
//
// A rhythm stays a rhythm where the result's notes lie on its grid. Elsewhere its notes are drawn,
// with their ramps, as an amplitude curve (model/algebra/drawn_notes.h). Carriers and modulation
// begin at their own phase at 0 s of the result, so that a joined or reversed beat may sit
// elsewhere.
//
// Source    ours; products of two slopes are drawn in 16 straight pieces, at most 0.1 % of full
//           scale off
// Input     a pattern without fault
// Output    a pattern without fault, or one sentence: "stretch: expected ..., got ..."
// Left out  two beds at once, which are layers (model/algebra/source_edits.h); what sounds of a
//           transient behind the end.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/common/units.h"
#include "model/pattern/pattern.h"
#include "model/physiology/mechanoreceptor.h"
#include "model/set/pattern_set.h"

namespace tact {

enum class EditKind {
    stretch,
    stretch_notes,
    stretch_curves,
    reverse,
    repeat,
    join,
    mix,
    trim,
    fade_in,
    fade_out,
    normalise,
    felt,
    quantise,
    quantise_bpm,
    transpose,
    thin,
    find_notes
};

inline constexpr std::size_t kEditKindCount = 17;

enum class EditNeeds { nothing, number, whole_number, pattern };

// One description of an edit, which the command line, the window and Python go by.
struct EditTraits {
    const char* key;    // "stretch-notes"; with two dashes it is the option
    const char* label;  // "Stretch the notes"
    const char* unit;   // of the number
    EditNeeds needs;
    Range range;   // of the number
    double start;  // what a person is offered first
    const char* help;
};

const EditTraits& traits(EditKind kind);
std::optional<EditKind> edit_kind(std::string_view key);

struct Edit {
    EditKind kind = EditKind::stretch;
    double number = 0.0;                     // where it needs one
    std::optional<VibrationSource> other{};  // where it needs a pattern
    std::string other_name{};                // of the layer that it may become

    bool operator==(const Edit&) const = default;
};

// "stretch: expected a number from 0.01 to 100, got 0"; empty: the edit can be asked for.
std::string fault_of(const Edit& edit);

// The edits in their order. `tables` hold the thresholds that `felt` goes by.
Expected<Pattern> edited(Pattern pattern, std::span<const Edit> edits,
                         const PhysiologyTables& tables);

}  // namespace tact
