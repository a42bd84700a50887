// Whether people notice what two patterns differ in, by the just noticeable differences of the
// textbook.
//
// Source    facts "frequency jnd" and "amplitude jnd" (textbook.h)
// Valid     patterns of one carrier each whose frequency is one number: of two that differ in it,
//           nothing is said of their amplitudes, which are then not felt alike. Those that share
//           their frequency differ in amplitude alone.
// Left out  rhythm and modulation: the textbook has no such difference for them
#pragma once

#include <string>

#include "model/pattern/pattern.h"

namespace tact {

// "People: 40 and 250 Hz differ by 525 %; they notice from 18 to 25 % on (...)." Empty: nothing to
// be said.
std::string noticed_text(const Pattern& a, const Pattern& b);

// People tell the two apart by their frequencies at once: by more than twice what is noticed.
bool tell_by_frequency(const Pattern& a, const Pattern& b);

}  // namespace tact
