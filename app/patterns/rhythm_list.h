// A list of rhythms: a choice of length, notes and their lengths, one row each, and the envelope of
// the row under the mouse.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/patterns/rhythm_choice.h"
#include "app/ui/ui.h"

namespace tact {

struct RhythmListAction {
    std::optional<std::string> pressed;
    std::optional<std::string> hovered;
    bool all = false;  // the link for all of them was pressed
};

// Call inside an open popup, which Esc closes. `chosen` tells which rows are highlighted. The
// envelope is that of `pattern` with the rhythm. `all`: label of a link for all of them; empty: no
// link.
RhythmListAction draw_rhythm_list(Ui& ui, RhythmChoice& choice, const Pattern& pattern,
                                  const std::function<bool(const std::string&)>& chosen,
                                  const std::string& all = {});

// Steps of a rhythm as a row of cells in an area; a held step is joined to the one before it.
void draw_rhythm_cells(const Theme& theme, const Rect& area, const std::string& text);

// "3 notes on 8 steps, evenness 0.97".
std::string rhythm_summary(const std::string& text);

}  // namespace tact
