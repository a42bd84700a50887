// How a pattern looks wherever it is shown: mark, colour, and a small picture of its waveform.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/marks.h"

namespace tact {

// Mark and colour of the pattern at a position: its own colour, else by position.
PatternLook look_of(const Theme& theme, const PatternSet& set, std::size_t index);
PatternLook look_of(const Ui& ui, const Workspace& work, std::size_t index);

// The waveform of a vibration without axes, each to its own height.
void draw_thumbnail(const Ui& ui, Workspace& work, const Rect& area, const Vibration& vibration,
                    ImU32 colour);

// All words of a set that are drawn: what fonts need glyphs for.
std::string drawn_text(const PatternSet& set);

}  // namespace tact
