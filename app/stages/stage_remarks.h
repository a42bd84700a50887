// Remarks on a stage of one pattern that is easily misread: a filter leaks, a gate is nearly always
// open or closed, receptors lie beyond the finger, more impulses than cycles.
//
// Input     one pattern's stages
// Output    numbers of this pattern; a sentence, or an empty text
#pragma once

#include <string>

#include "app/physiology/live_stages.h"
#include "app/physiology/stages.h"

namespace tact {

// Share of the steps in which the centre of a type's network sends anything.
double share_on(const LiveStages& live, Receptor receptor);

// Share of the steps in which it sends the model's maximum.
double share_at_cap(const LiveStages& live, Receptor receptor);

// Number of the grid's receptors beyond the finger's edge.
std::size_t beyond_finger(const LiveStages& live, Receptor receptor);

// Remark on one type's impulses, beside its rows: "filter leak", "11.5 a cycle"; empty: no remark.
std::string firing_note(const LiveStages& live, Receptor receptor);

// The same in a few words, for a small stage: types that only leak, types with many impulses a
// cycle.
std::string short_remark(const LiveStages& live, Stage stage);

// Remark for the line under a stage's title; empty: no remark. `has_textbook`: leaves out whatever
// the measured facts over the stage say.
std::string stage_remark(const LiveStages& live, Stage stage, bool has_textbook = false);

}  // namespace tact
