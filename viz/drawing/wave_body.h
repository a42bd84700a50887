// A wave in pixel columns, drawn true where its periods are narrower than can be seen.
//
// The least and the most of each column alone is a lie there: with two to four columns a period
// some columns miss the crest and some the trough, and a plain tone looks modulated. Where crests
// follow each other within a few columns, the valleys between them are filled: by straight lines
// from crest to crest, so that what is slower, as a modulation, is drawn unchanged. Crests of
// crests come next, until those left are far enough apart: every period of a sum of tones that is
// too narrow becomes body, and no other.
//
// A body alone would show a tone in waves as the steady one that its crests are as high as. So it
// is told how strong each column is beside a steady tone that fills it.
//
// Input     samples of any number: one pass over those in view
// Valid     a lone click, two of them, and pauses between bursts stay what they are: filled is only
//           what repeats. Tones of more than eight samples a period have the crests between their
//           samples.
// Left out  logarithmic axes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "viz/drawing/plot.h"

namespace tact {

struct BodyScale {
    double widest = 6.0;  // columns of a period that is not seen as one
    double least = 0.0;   // of values: what makes no difference on the screen
};

struct WaveBody {
    std::vector<Extremes> columns;
    // As many: root mean square of what was filled, by that of a tone as high; 1 where nothing was.
    std::vector<double> strength;
    std::vector<bool> filled;  // as many: within periods that are too narrow to be seen

    bool operator==(const WaveBody&) const = default;
};

// How opaque a column of that strength is drawn: what is modulated faster than can be seen is the
// lighter the weaker it is beside a steady tone. 1: no lighter than the colour it has.
double body_tone(double strength);

// As `extremes` (plot.h), which these columns contain.
WaveBody wave_body(std::span<const double> samples, double first, double last, std::size_t columns,
                   const BodyScale& scale);

// Its columns alone.
std::vector<Extremes> body_columns(std::span<const double> samples, double first, double last,
                                   std::size_t columns, const BodyScale& scale);

// Samples before `first` and behind `last` that the columns also depend on: those beyond the view
// tell how the wave at its edge continues.
double reach_beyond(double first, double last, std::size_t columns, const BodyScale& scale);

}  // namespace tact
