// The four mechanoreceptor types of glabrous skin: where they respond, how strongly, how far.
//
// Source    Lim & Park 2023, section 4.1, Eqs. 1-3; densities Johansson & Vallbo 1979; hot zone and
//           probe Johnson 1974. Slopes and thresholds: assets/physiology, with their sources.
// Input     the amplitude spectrum of the vibration at the skin under the probe
// Output    mean firing rate at the centre, its fall with distance, radius of activation
// Valid     1-500 Hz, 0.5 mm probe on the fingertip
// Left out  adaptation, plateaus of the rate-intensity functions, skin mechanics beyond a power
//           law, more than one contact.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/common/units.h"

namespace tact {

enum class Receptor { meissner, pacinian, merkel, ruffini };

inline constexpr std::size_t kReceptorCount = 4;
inline constexpr std::array<Receptor, kReceptorCount> kReceptors{
    Receptor::meissner, Receptor::pacinian, Receptor::merkel, Receptor::ruffini};

// One value for each receptor type.
template <class Value>
using PerReceptor = std::array<Value, kReceptorCount>;

constexpr std::size_t index_of(Receptor receptor) { return static_cast<std::size_t>(receptor); }

// Names of a type in the field, and the paper's constants for it.
struct ReceptorTraits {
    const char* name;      // Meissner
    const char* afferent;  // FA1
    const char* channel;   // NP I
    double low_hz;         // lower band edge; 0: low-pass
    double high_hz;
    double density_per_mm2;
    bool rapidly_adapting;  // fires on change: the perceived waveform is differentiated
};

const ReceptorTraits& traits(Receptor receptor);

// Spacing of receptors on a square grid of the type's density: 1 / sqrt(density).
double grid_interval_mm(Receptor receptor);

// A curve over frequency, linear in log10 f between knots and constant beyond the outermost ones.
struct Curve {
    std::vector<double> frequency_hz;  // ascending, > 0
    std::vector<double> value;         // one per frequency

    bool operator==(const Curve&) const = default;
};

double at(const Curve& curve, double frequency_hz);

struct PhysiologyTables {
    PerReceptor<Curve> slope;      // alpha: impulses/s per log10 um
    PerReceptor<Curve> threshold;  // beta: log10 um peak

    bool operator==(const PhysiologyTables&) const = default;
};

// The tables compiled in from assets/physiology.
const PhysiologyTables& default_tables();

// The unit of a table and its possible values: a table in another unit is refused.
struct TableTraits {
    const char* name;
    const char* column;
    Range values;
    const char* expected;  // words for the unit
};
inline constexpr TableTraits kSlopeTable{"slope table",
                                         "slope_imp_per_s_per_log10um",
                                         {0.0, 1e4},
                                         "impulses/s per log10 um from 0 to 10000"};
inline constexpr TableTraits kThresholdTable{
    "threshold table",
    "threshold_log10_um_peak",
    {-4.0, 6.0},
    "log10 of um peak from -4 to 6 (beyond them it looks like dB, which are 20 times that)"};

// Our thresholds shifted to the perceptible amplitudes of the Android Open Source Project, also
// compiled in.
const PerReceptor<Curve>& aosp_thresholds();

// One table in the layout of assets/physiology, from the text of its file. An Error names the
// table, the line and what was expected.
Expected<PerReceptor<Curve>> parse_slopes(const std::string& csv);
Expected<PerReceptor<Curve>> parse_thresholds(const std::string& csv);

// Tables in the layout of assets/physiology, from the texts of its two files. An Error names the
// table, the line and what was expected.
Expected<PhysiologyTables> parse_tables(const std::string& slopes_csv,
                                        const std::string& thresholds_csv);

}  // namespace tact
