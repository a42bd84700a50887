// Parts that the files of this room share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/generate/generate.h"
#include "app/ui/ui.h"

namespace tact {

// The entries that the rows of the dialog for candidates are made of.

// What is shown is the value times the factor.
struct Unit {
    const char* name;
    double times;
};

Unit unit_of(Parameter parameter);

// What stands between blanks, commas and semicolons.
std::vector<std::string> words_in(const std::string& text);

// An entry shows `shown`, and while it is typed in, that. The text, where it is another one.
std::optional<std::string> draw_entry(Ui& ui, GenerateState& generating, const std::string& id,
                                      const std::string& shown, float width);

// A single number, and a whole one. What is typed and cannot be leaves it as it was before.
void draw_number(Ui& ui, const std::string& id, double& value, Range allowed,
                 const Unit& unit = {"", 1.0});
void draw_whole(Ui& ui, const std::string& id, int& value, Range allowed);

// A switch, and a link; the next item stands beside them.
bool option_chip(Ui& ui, const std::string& id, const char* text, bool lit, const char* help);
bool option_link(Ui& ui, const char* id, const char* text);

// A little room before the next item of a row.
void leave_gap(const Ui& ui);

// Dim text after the last item.
void beside(const Ui& ui, const char* text);

// What is wrong with the text of an entry, at the end of its row: the draft then stays as it was
// before, and the fault stands there also when the entry is left, as what was typed is gone.
// Without a fault, what the row amounts to. `is_typed`: its text changed in this frame.
void draw_remark(Ui& ui, GenerateState& generating, const std::string& id, bool is_typed,
                 const std::string& remark, const std::string& fault);

// The rows of the dialog for candidates: what every parameter may be, how many are made, and what
// they must keep to.

void draw_factor_rows(Ui& ui, GenerateState& generating);
void draw_design_row(Ui& ui, GenerateState& generating);
void draw_constraint_rows(Ui& ui, GenerateState& generating);

}  // namespace tact
