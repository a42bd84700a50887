// Patterns of layers: bed, notes, ticks and recordings that sound at once.
//
//     x(t) = sum_l g_l c_l(t - o_l) + the transients of all layers, g_l strong and o_l later
//
// The sum is over the layers that are solo; without such, over all that are not mute. c_l is what a
// layer's pattern is without its transients, or its recording. Transients are joined to the sum of
// what sounds under them, as those of one pattern are (model/pattern/accents.h), so that no phase
// between two layers decides a number of theirs; those that a pattern adds stay in its c_l.
//
// Source    ours
// Input     layers without fault: fault_of()
// Output    as long as the last layer, mute ones too: muting one moves nothing
// Valid     one to four layers; an offset is rounded to a sample
// Exact     one layer of gain 1 at 0 s is its pattern, to the last bit
#pragma once

#include <string>
#include <vector>

#include "model/common/units.h"
#include "model/set/pattern_set.h"

namespace tact {

namespace limits {
inline constexpr Range kLayerGain{0.0, 10.0};
inline constexpr Range kLayerOffsetS{0.0, 60.0};
inline constexpr std::size_t kMaxLayers = 4;
}  // namespace limits

bool sounds(const LayeredPattern& layered, std::size_t k);

double duration_s(const Layer& layer);  // of its own, without the offset
double duration_s(const LayeredPattern& layered);

Waveform render(const LayeredPattern& layered, double rate_hz = kModelRateHz);

// What is wrong, as the end of a sentence; empty: nothing.
std::string fault_of(const LayeredPattern& layered);

// "bed", or "layer 2" where it has no name.
std::string name_of(const LayeredPattern& layered, std::size_t k);

// All recordings of a vibration: itself, or those of its layers.
std::vector<Measurement*> recordings_in(Vibration& vibration);
std::vector<const Measurement*> recordings_in(const Vibration& vibration);

// Whether it was computed in the place of a recording, or one of its layers was.
bool is_synthetic(const Vibration& vibration);

// All patterns made of parameters of a vibration: itself, or those of its layers.
std::vector<const Pattern*> patterns_in(const Vibration& vibration);

// A pattern or a recording as the one layer of a layered pattern; a layered one as it is.
LayeredPattern as_layers(const VibrationSource& source);

// Patterns that begin together, as layers.
LayeredPattern layers_of(std::vector<Pattern> patterns);

// A single layer that is neither changed in gain nor moved nor mute is its pattern or recording.
VibrationSource without_needless_layers(LayeredPattern layered);

// The sum as one recording without a file, in g.
Measurement flattened(const LayeredPattern& layered);

}  // namespace tact
