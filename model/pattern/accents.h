// Transients joined to what sounds under them.
//
// No format says in which phase a transient meets what sounds under it, so no number may depend on
// it. A transient over silence begins at phase 0, whatever other transients it overlaps. Over a
// carrier, its phase is the one at which it adds as an energy to all that sounds under it, earlier
// transients too: the sum of their products is 0. Two phases do that, half a turn apart; it is the
// one that makes the first half of the transient the stronger one. Transients that begin at one
// time are one accent: each is joined to what sounds under all of them. A carrier that could change
// the transient's energy by no more than 4 % in any phase, as one that ends in its flank, does not
// count.
//
// Source    ours
// Output    energy over a transient = energy under it + the transient's own
// Exact     transients over silence are added as they are, to the last bit
#pragma once

#include "model/pattern/curves.h"
#include "model/signal/waveform.h"

namespace tact {

// The transient so long after its beginning, which is at that phase; 0 g outside of its duration.
double transient_g(const Transient& transient, double since_s, double phase_turns);

// Adds them, in any order, to the carriers, which the waveform is; what lies behind the waveform's
// end is cut.
void add_accents(Waveform& waveform, std::vector<Transient> transients);

// Adds each of them at phase 0, whatever sounds under it.
void add_transients(Waveform& waveform, const std::vector<Transient>& transients);

}  // namespace tact
