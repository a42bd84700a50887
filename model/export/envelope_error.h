// How far what came back of an export is from what was meant, for who feels it: the one judge
// behind all writers and readers.
//
// Both are rendered twice, a quarter of a turn apart, which gives the strength of their carriers at
// every sample; with the transients joined in power, their root mean square in each ms is held
// against the other's as a tone (shares.h). What is not off within 1 ms before or behind is not
// off: so a jump that moves by 1 ms costs nothing.
//
// An accent is a transient that stands out, for who feels it, from what is before and behind it. It
// is left where what comes back is at least half as strong then and stands out half as much.
//
// Source    ours; model/io/effects_out/shares.h
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Left out  phases; spectra within the strongest carrier's tone.
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

struct EnvelopeError {
    double error_db = 0.0;  // the largest, of level or of the frequency's ratio
    double at_s = 0.0;      // where it first is
    double meant_s = 0.0;   // how long it was meant to last ...
    double lasts_s = 0.0;   // ... and lasts as it comes back
    std::size_t accents = 0;
    std::size_t accents_left = 0;
    bool is_silenced = false;  // something was to be felt, and nothing can be

    bool operator==(const EnvelopeError&) const = default;
};

EnvelopeError envelope_error(const Pattern& meant, const Pattern& back);

// More than 0.1 dB or 1 ms off, or an accent gone.
bool is_lossy(const EnvelopeError& error);

// Sentences without their stop, the most important last: "lasts 422 ms in place of 400 ms", "at
// most 2.1 dB off where it is felt, at 0.035 s", "12 of 299 accents are left", "nothing of this can
// be felt on the target". Nothing where nothing is lossy.
std::vector<std::string> words_of(const EnvelopeError& error);

// What is_silenced is said as.
inline constexpr const char* kSilenced = "nothing of this can be felt on the target";

}  // namespace tact
