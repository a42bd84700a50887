// The entry that every number of the window is typed in.
//
// A click selects all of it. Enter, Tab and leaving it take what is typed, Esc does not. Up, down
// and the wheel step, Shift coarsely, Alt finely, and are taken at once. What is no number is
// refused and told, what is out of range is clamped and told; a text that stands as it stood
// changes nothing, though the number has more digits than are shown. A double click on its label
// brings its default back.
#pragma once

#include <optional>
#include <string>

#include "app/ui/ui.h"
#include "model/text/typed_number.h"

namespace tact {

inline constexpr double kCoarse = 5.0;  // steps with Shift
inline constexpr double kFine = 0.1;    // and with Alt

struct NumberEntry {
    std::string id;      // within its window; its name for tests is of who draws it
    std::string label;   // what a refusal calls it
    const char* format;  // of printf, with the unit
    NumberRules rules;
    float width_px = 0.0F;
    double step = 0.0;   // 0: one of the second digit
    bool live = false;   // what is good is taken while it is typed; what is left bad, taken back
    bool mixed = false;  // it stands for several that differ: in words, until one is typed for all
};

// How a number went from one value to another: others that it stands for follow it so.
enum class Along {
    same,    // all become what it is
    factor,  // each times the same
    ratio,   // times what this is to what it was when the gesture began
    step,    // each by the same difference
    back     // each to what it was when the gesture began
};

struct NumberEdit {
    bool changed = false;  // to another value; of several that differ, perhaps to the same
    bool begun = false;    // the entry has got the keyboard
    Along along = Along::same;
    double factor = 1.0;
};

// It is the last ImGui item then.
NumberEdit edit_entry(Ui& ui, const NumberEntry& entry, double& value);

// True when another number was taken.
bool enter_number(Ui& ui, const NumberEntry& entry, double& value);

// How many steps the wheel turns over the last item, which scrolls nothing then.
int wheel_steps(Ui& ui);

// The last item, the label of a number, was double-clicked: its default is asked for.
bool is_reset_asked(const Ui& ui);

// Takes it then. True when it is another number.
bool reset_by_label(const Ui& ui, double normal, double& value);
bool reset_by_label(const Ui& ui, int normal, int& value);

// In this frame or in the last one a number was typed: Enter and Esc are its own.
bool is_number_typed(const Ui& ui);

// The undo step of this frame is one with the last, if that was a moment ago and by the same keys.
void join_steps(Ui& ui, const std::string& field);

// A whole one.
bool enter_whole(Ui& ui, const NumberEntry& entry, int& value);

// With a button for one less and one for one more, within the width.
bool enter_whole_with_buttons(Ui& ui, const NumberEntry& entry, int& value);

}  // namespace tact
