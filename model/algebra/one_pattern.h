// A layered pattern as one without layers, for formats that hold no more; or its beds as patterns
// that begin together, for one that holds several.
//
// One bed, with ticks in any layer, becomes that bed at its place, which is exact but for a
// modulation that would have to begin later. Several beds at once are traced as one carrier.
//
// Source    ours; traces: model/pattern/traced.h
// Input     layers without fault
// Output    a pattern without fault; what it is not exactly the sum of, in words
#pragma once

#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

struct OnePattern {
    Pattern pattern;
    std::vector<std::string> remarks;  // sentences without a stop; none: it is the sum
};

OnePattern as_one_pattern(const LayeredPattern& layered);

// A bed of the layered pattern, at its place, and as long as the whole.
struct PlacedBed {
    std::string name;  // of its layer
    Pattern pattern;   // of the first one with the transients of all
    std::vector<std::string> remarks;
};

// Empty where it has fewer than two beds, or one of them is a recording.
std::vector<PlacedBed> as_placed_beds(const LayeredPattern& layered);

}  // namespace tact
