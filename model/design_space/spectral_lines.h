// The sinusoids that a pattern consists of while a note sounds: carriers and their sidebands.
//
//     sin(a) sin(b) = (cos(a - b) - cos(a + b)) / 2
//
// Source    trigonometry; the pattern is Eq. 7 of Lim & Park 2023, generalised.
// Output    lines of different frequencies, ascending, none at 0 Hz and none of no strength
// Valid     for what lasts longer than its rhythm's edges: those spread every line; for patterns
//           without curves and transients, as candidates are
// Left out  rhythm and ramps; aliasing of lines above half the rate.
#pragma once

#include <optional>
#include <vector>

#include "model/pattern/pattern.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

struct SpectralLine {
    double frequency_hz = 0.0;
    double amplitude_g = 0.0;  // peak
};

std::vector<SpectralLine> spectral_lines(const Pattern& pattern);

// Peak displacement if all lines ever meet at their peaks: no pattern of these lines exceeds it.
double most_displacement_um(const std::vector<SpectralLine>& lines);

// By how much the line that stands out most is above the threshold of the receptor type that feels
// it best, dB. Lines outside of what drives receptors do not count; none: nothing is felt.
std::optional<double> detectability_db(const std::vector<SpectralLine>& lines,
                                       const PhysiologyTables& tables);

}  // namespace tact
