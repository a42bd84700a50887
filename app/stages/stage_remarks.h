// What misleads in a stage of one pattern, said where it is seen: what a filter leaks, a gate that
// is nearly on or off, receptors beyond the finger.
//
// Input     one pattern's stages
// Output    numbers of this pattern; a sentence, or nothing where there is nothing to say
#pragma once

#include <string>

#include "app/physiology/live_stages.h"
#include "app/physiology/stages.h"

namespace tact {

// What a filter lets through, and the strongest component in its band, are at most this share of
// the vibration's: nothing of the type's band, but what the filter leaks, and how it rings where
// the vibration begins and ends. [ours]
inline constexpr double kLeakShare = 0.05;

// The type follows nothing but what its filter leaks.
bool only_leaks(const LiveStages& live, Receptor receptor);

// Share of the steps in which the centre of a type's network sends anything at all.
double share_on(const LiveStages& live, Receptor receptor);

// The same of the steps in which it sends as much as the model lets it.
double share_at_cap(const LiveStages& live, Receptor receptor);

// Receptors of the grid that lie beyond the finger's edge.
std::size_t beyond_finger(const LiveStages& live, Receptor receptor);

// For the line under a stage's title; empty: nothing to say.
std::string stage_remark(const LiveStages& live, Stage stage);

}  // namespace tact
