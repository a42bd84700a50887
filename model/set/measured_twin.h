// A measured vibration as the twin of the intended pattern that was played.
//
// Source    intended and measured stimuli (IPS, MPS) of Lim & Park 2023, section 6
// Output    the recording's part that holds the pattern, named after it and saying what it measures
// Left out  files: a new twin has none yet (model/io/set/measured_files.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/set/pattern_set.h"
#include "model/signal/alignment.h"
#include "model/signal/simulated_measurement.h"

namespace tact {

struct Twin {
    Vibration vibration;  // "NAME measured", or "NAME synthetic"
    Alignment alignment;  // its waveform is the vibration's
};

// Samples are rounded to what the file keeps (32 bits), so that a set read again is the same set.
Twin measured_twin(const Vibration& intended, const Waveform& recording);
Twin synthetic_twin(const Vibration& intended, const ActuatorParams& params);

// Puts the twin behind its intended pattern and the twins that has, under a name that is free, and
// gives its place. The pattern it measures must be there.
std::size_t insert_twin(PatternSet& set, Vibration twin);

// Synthetic twins of the vibrations at these places (default: all), each with noise of its own. A
// vibration that is itself a measurement is left out.
std::vector<Twin> synthetic_twins(const PatternSet& set, const std::vector<std::size_t>& places,
                                  const ActuatorParams& params);

// The set with such twins of all.
PatternSet with_synthetic_twins(const PatternSet& set, const ActuatorParams& params);

// The vibration that a recording of this file stem measures, by name: "l-4_full measured 2" is of
// "L-4-full". None, where no name or none alone fits.
std::optional<std::size_t> guessed_intended(const PatternSet& set, std::string_view stem);

// The twin of another vibration?
bool measures_another(const Vibration& vibration);

// Which of the two sides of a set counts.
enum class Side { both, intended, measured };
inline constexpr const char* kSideNames[] = {"both", "intended", "measured"};

// The set without the vibrations of the other side. On the measured side what people said of an
// intended pattern counts for its first twin.
PatternSet one_side(const PatternSet& set, Side side);

// The first twin of every pattern that has one, under its pattern's name: what ratings of the
// intended patterns are held against.
PatternSet measured_stand_ins(const PatternSet& set);

}  // namespace tact
