// What misleads in a stage of one pattern, said where it is seen: what a filter leaks, a gate that
// is nearly on or off, receptors beyond the finger, more impulses than cycles.
//
// Input     one pattern's stages
// Output    numbers of this pattern; a sentence, or nothing where there is nothing to say
#pragma once

#include <string>

#include "app/physiology/live_stages.h"
#include "app/physiology/stages.h"

namespace tact {

// Share of the steps in which the centre of a type's network sends anything at all.
double share_on(const LiveStages& live, Receptor receptor);

// The same of the steps in which it sends as much as the model lets it.
double share_at_cap(const LiveStages& live, Receptor receptor);

// Receptors of the grid that lie beyond the finger's edge.
std::size_t beyond_finger(const LiveStages& live, Receptor receptor);

// Of one type's impulses, beside its rows: "filter leak", "11.5 a cycle"; empty: nothing misleads.
std::string firing_note(const LiveStages& live, Receptor receptor);

// The same in a few words, for beside a small stage: who only leaks, who fires many a cycle.
std::string short_remark(const LiveStages& live, Stage stage);

// For the line under a stage's title; empty: nothing to say. `has_textbook`: measured facts are
// laid over the stage, and what they say is left to them.
std::string stage_remark(const LiveStages& live, Stage stage, bool has_textbook = false);

}  // namespace tact
