// Whether people notice the difference of two patterns, by the just noticeable differences of the
// textbook.
//
// Source    facts "frequency jnd" and "amplitude jnd" (textbook.h)
// Valid     patterns with one carrier each, of constant frequency. If the frequencies differ,
//           nothing is said of the amplitudes, which are then felt at different strengths; if they
//           are equal, the patterns differ in amplitude alone.
// Left out  rhythm and modulation: the textbook has no such difference for them
#pragma once

#include <string>

#include "model/pattern/pattern.h"

namespace tact {

// "People: 40 and 250 Hz differ by 525 %; they notice from 18 to 25 % on (...)."; empty if there is
// nothing to tell.
std::string noticed_text(const Pattern& a, const Pattern& b);

// Whether people tell the two apart by their frequencies at once: the difference is more than twice
// the noticeable one.
bool tell_by_frequency(const Pattern& a, const Pattern& b);

}  // namespace tact
