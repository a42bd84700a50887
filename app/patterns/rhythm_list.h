// Rhythms by the list: a choice of length, notes and their lengths, a row each, and the envelope of
// the one that is pointed at.
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

// Inside an open popup, which Esc closes. `chosen` tells which rows are lit. The envelope is that
// of `pattern` with the rhythm. A link for all of them is there where `all` is not empty: its
// words.
RhythmListAction draw_rhythm_list(Ui& ui, RhythmChoice& choice, const Pattern& pattern,
                                  const std::function<bool(const std::string&)>& chosen,
                                  const std::string& all = {});

// Steps of a rhythm as a row of cells in an area; a held step joins the one before it.
void draw_rhythm_cells(const Theme& theme, const Rect& area, const std::string& text);

// "3 notes on 8 steps, evenness 0.97".
std::string rhythm_summary(const std::string& text);

}  // namespace tact
