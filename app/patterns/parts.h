// Parts that the files of this room share.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include "app/document/workspace.h"
#include "app/patterns/patterns.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/pattern/pattern_numbers.h"

namespace tact {

// Groups of fields that make up the editor of a pattern.

// A number of a pattern; null if the pattern does not have it, such as a third carrier.
using ReadNumber = std::function<std::optional<double>(const Pattern&)>;
using WriteNumber = std::function<void(Pattern&, double)>;

// One gesture on one number: it changes all selected patterns, one step of undo when it ends. If
// their values differ, a typed value goes to all of them; a drag keeps their ratios, or their
// differences if one is not above 0. `what` is its name in the step's label.
void edit_number(Ui& ui, Workspace& work, Field field, const std::string& what,
                 const ReadNumber& read, const WriteNumber& write);

// The same of a number that is described, which `at` finds in a pattern: a pointer, null where it
// has none.
template <class At>
void edit_number(Ui& ui, Workspace& work, const Number& number, const Field& field,
                 const std::string& what, At at) {
    edit_number(
        ui, work, field, what,
        [at, &number](const Pattern& pattern) -> std::optional<double> {
            const auto* value = at(pattern);
            if (value == nullptr) return std::nullopt;
            return number.times * *value;
        },
        [at, &number](Pattern& pattern, double shown) {
            auto* value = at(pattern);
            if (value == nullptr) return;
            const double kept = shown / number.times;
            if constexpr (std::is_same_v<decltype(value), int*>) {
                *value = static_cast<int>(std::lround(number.clamped(kept)));
            } else {
                *value = kept;
            }
        });
}

// A link among the fields, which a locked pattern disables. True if pressed.
bool field_link(Ui& ui, const Workspace& work, const char* id, const std::string& label,
                const char* tip);

// The nearest step above 0; without steps, the value itself.
double snapped_to(double value, double snap);

// Adds a carrier at three times the last one's frequency, at most 500 Hz, if there is room. All
// carriers get equal shares, so that the pattern does not get stronger.
void push_carrier(Pattern& pattern);

// Carriers, their mix or weights, and the warning of leakage.
void draw_carrier_fields(Ui& ui, Workspace& work, const Pattern& pattern);

// The rhythm as text and as a grid of steps.
void draw_rhythm_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                        const Pattern& pattern);

// A recording in the editor: gain, part and fades, and a pattern traced from it.
//
// Left out  several recordings at once: each has its own length.

// The selected part of the waveform, with its gain and fades. Samples are rounded to the 32 bits of
// its file.
Waveform cut(const Waveform& recording, const RecordingCut& how);

// "Cut from FILE: +3 dB, 0.2 to 1.4 s, fades of 10 and 20 ms."; empty if nothing was cut.
std::string cut_note(const RecordingCut& how, double length_s, const std::string& path);

// Draws nothing unless the current vibration is a recording.
void draw_recording_editor(Ui& ui, Workspace& work, RecordingEditor& editor);

// Call in an open popup: moves it up if it would end below the window.
void keep_on_screen(const Theme& theme);

}  // namespace tact
