// What an effect file asks for, as one of our patterns.
//
// A file may hold many continuous vibrations; a pattern has one amplitude curve and one frequency
// curve. One after the other they share the two, with jumps. Where several sound at once:
//   - the same envelope and a fixed ratio of frequencies make them carriers of one pattern;
//   - else the amplitude is the root of the sum of their squares, where any of them has a point and
//     straight between, and the frequency that of the strongest; a remark says so.
// What exceeds the limits of a pattern is cut in time, never thinned into another rhythm, and a
// remark says that, too.
//
// Valid     times of 0 s or more; at most kMostVoices, kMostVoicePoints in all of them, and
//           kMostAtOnce at one time
// Left out  the phase with which each vibration begins: the oscillator runs through.
#pragma once

#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/pattern/pattern.h"

namespace tact {

inline constexpr std::size_t kMostVoices = 10'000;
inline constexpr std::size_t kMostVoicePoints = 100'000;
inline constexpr std::size_t kMostAtOnce = 100;

struct Voice {
    double start_s = 0.0;
    double end_s = 0.0;
    AmplitudeCurve amplitude;  // values in g, of any size; held outside of the points
    FrequencyCurve frequency;  // at least one point
    double phase_rad = 0.0;
};

struct Sketch {
    std::vector<Voice> voices;
    std::vector<Transient> transients;
    double duration_s = 0.0;  // the pattern is at least so long
    double unit_g = 1.0;      // the pattern's amplitude, where no voice exceeds it
};

// Without fault (model/pattern/drawn_fault.h). An Error has no file's name.
Expected<Pattern> pattern_of(const Sketch& sketch, std::vector<std::string>& remarks);

// Whether all have one course, but for strength and pitch, so that they are carriers of one
// pattern.
bool are_carriers(const std::vector<Voice>& voices);

// What is wrong with this number of vibrations and points, or empty; readers ask while they read.
std::string size_fault(const Sketch& sketch, std::size_t points);

// Without the points outside of its time, which many voices of one control would keep each.
Voice cut_out(Voice voice);

// The value just before and just behind a time.
struct Sides {
    double before;
    double behind;
};
Sides sides_at(const AmplitudeCurve& curve, double t_s);
Sides sides_at(const FrequencyCurve& curve, double t_s);

}  // namespace tact
