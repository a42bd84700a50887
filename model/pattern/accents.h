// Transients joined to what sounds under them.
//
// No format says in which phase a transient meets what sounds under it, so no number may depend on
// it. A transient over silence begins at phase 0. Over anything else, which is the carriers and the
// transients that begin before it, its phase is the one at which both add as energies: the sum of
// their products is 0. Two phases do that, half a turn apart; it is the one that makes the first
// half of the transient the stronger one. Transients that begin at one time are one accent: each
// is joined to what sounds under all of them.
//
// Source    ours
// Output    energy over a transient = energy under it + the transient's own
#pragma once

#include "model/pattern/curves.h"
#include "model/signal/waveform.h"

namespace tact {

// The transient so long after its beginning, which is at that phase; 0 g outside of its duration.
double transient_g(const Transient& transient, double since_s, double phase_turns);

// Adds them, in any order; what lies behind the waveform's end is cut.
void add_accents(Waveform& waveform, std::vector<Transient> transients);

}  // namespace tact
