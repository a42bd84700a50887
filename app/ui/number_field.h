// The entry for every number of the window.
//
// A click selects all of it. Enter, Tab and leaving it accept the typed text, Esc does not. Up,
// down and the wheel step, Shift coarsely, Alt finely, and take effect at once. Text that is not a
// number is refused with a message, a number out of range is clamped with a message. Unchanged text
// changes nothing, even if the number has more digits than are shown. A double click on its label
// restores its default.
#pragma once

#include <optional>
#include <string>

#include "app/ui/ui.h"
#include "model/text/typed_number.h"

namespace tact {

inline constexpr double kCoarse = 5.0;  // steps with Shift
inline constexpr double kFine = 0.1;    // and with Alt

struct NumberEntry {
    std::string id;      // within its window; the caller gives the name for tests
    std::string label;   // its name in messages
    const char* format;  // of printf, with the unit
    NumberRules rules;
    float width_px = 0.0F;
    double step = 0.0;   // 0: one in the second digit
    bool live = false;   // valid text takes effect while typing; leaving the entry with invalid
                         // text restores the number
    bool mixed = false;  // shown while several numbers differ, until one is typed for all
};

// The way a number changed; others that it stands for change in the same way.
enum class Along {
    same,    // all get its value
    factor,  // each times the factor
    ratio,   // times the ratio of its value to that at the beginning of the gesture
    step,    // each by the same difference
    back     // each to its value at the beginning of the gesture
};

struct NumberEdit {
    bool changed = false;  // to another value; if several differ, perhaps to the same
    bool begun = false;    // the entry has got the keyboard
    Along along = Along::same;
    double factor = 1.0;
};

// The entry is the last ImGui item afterwards.
NumberEdit edit_entry(Ui& ui, const NumberEntry& entry, double& value);

// True if the number changed.
bool enter_number(Ui& ui, const NumberEntry& entry, double& value);

// Steps of the wheel over the last item; it scrolls nothing then.
int wheel_steps(Ui& ui);

// Whether the last item, the label of a number, was double-clicked to restore its default.
bool is_reset_asked(const Ui& ui);

// Restores the default then. True if the number changed.
bool reset_by_label(const Ui& ui, double normal, double& value);
bool reset_by_label(const Ui& ui, int normal, int& value);

// Whether a number was typed in this frame or the last one: Enter and Esc belong to it.
bool is_number_typed(const Ui& ui);

// Merges the undo step of this frame with the last one, if that was a moment ago and by the same
// keys.
void join_steps(Ui& ui, const std::string& field);

// A whole number.
bool enter_whole(Ui& ui, const NumberEntry& entry, int& value);

// With buttons for one less and one more, within the width.
bool enter_whole_with_buttons(Ui& ui, const NumberEntry& entry, int& value);

}  // namespace tact
