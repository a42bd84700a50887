// A design space: which values every parameter of a vibration may take, and which of the
// combinations are wanted.
//
// Source    factorial designs; Latin hypercubes: McKay, Beckman & Conover 1979; Sobol's sequence:
//           model/design_space/sobol.h.
// Valid     at most limits::kMaxPatterns combinations; 1 to 8 carriers
// Left out  carriers' phases, which are 0; different numbers of carriers: a weight of 0 leaves one
//           out. Curves and transients: candidates have none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

// Any value between two, both included. In a full factorial design `steps` of them, evenly spaced.
struct Span {
    double from = 0.0;
    double to = 1.0;
    int steps = 3;
    bool logarithmic = false;  // evenly spaced in ratio
    double multiple_of = 0.0;  // values are moved to the nearest multiple of it; 0: they are not

    bool operator==(const Span&) const = default;
};

// Levels, of which one is a fixed value; or a range.
using Values = std::variant<std::vector<double>, Span>;

inline Values fixed(double value) { return std::vector<double>{value}; }

struct CarrierValues {
    Values frequency_hz = fixed(150.0);
    Values weight = fixed(1.0);

    bool operator==(const CarrierValues&) const = default;
};

enum class Design {
    factorial,        // every combination of levels, the last parameter changing fastest
    latin_hypercube,  // every range cut in as many parts as there are samples, each used once
    sobol             // the first points of the sequence
};

// What a candidate must keep to; see model/design_space/spectral_lines.h.
struct Constraints {
    std::optional<Range> band_hz;           // of the device: all lines lie in it
    std::optional<double> displacement_um;  // peak, at most
    std::optional<double> detectable_db;    // one line at least so far above threshold

    bool operator==(const Constraints&) const = default;
};

struct DesignSpace {
    Values amplitude_g = fixed(1.0);
    std::vector<CarrierValues> carriers = std::vector<CarrierValues>(1);
    std::optional<Values> mix;  // share of the second of two carriers: instead of their weights
    std::vector<ModulationKind> kinds{ModulationKind::product};
    Values modulation_hz = fixed(0.0);
    Values depth = fixed(1.0);
    std::vector<std::string> rhythms{
        ""};  // texts of model/pattern/rhythm.h; empty: one note throughout
    Values unit_s = fixed(0.125);
    Values attack_s = fixed(0.0);
    Values release_s = fixed(0.0);
    Values duration_s = fixed(1.0);
    Design design = Design::factorial;
    int samples = 100;  // of the other designs
    int seed = 0;       // 0: Sobol's sequence as it is published
    Constraints constraints;

    bool operator==(const DesignSpace&) const = default;
};

namespace limits {
inline constexpr Range kSamples{1, kMaxPatterns};
inline constexpr Range kSeed{0, 1'000'000'000};
inline constexpr Range kSpanSteps{2, 1000};
inline constexpr Range kMultiple{0.0, 1000.0};
inline constexpr Range kMix{0.0, 1.0};
inline constexpr Range kBandHz{0.0, 5000.0};
inline constexpr Range kDisplacementUm{0.0, 1e6};
inline constexpr Range kDetectableDb{-100.0, 100.0};
inline constexpr std::size_t kMaxLevels = 1000;
}  // namespace limits

enum class Parameter {
    amplitude,
    frequency,
    weight,
    mix,
    kind,
    modulation,
    depth,
    rhythm,
    unit,
    attack,
    release,
    duration
};

// A parameter of a design space; of frequency and weight, that of one carrier.
struct Factor {
    Parameter parameter = Parameter::amplitude;
    std::size_t carrier = 0;

    bool operator==(const Factor&) const = default;
};

// All there are, in the order in which they vary from slowest to fastest; weights only where there
// is no mix.
std::vector<Factor> factors(const DesignSpace& space);

// "Amplitude", "Carrier 2", "Weight 2".
std::string name_of(Factor factor);

// The numbers that a factor may take; null for kind and rhythm.
const Values* values_of(const DesignSpace& space, Factor factor);
Values* values_of(DesignSpace& space, Factor factor);

// What a person may choose there; asserts that there are numbers.
Range range_of(Parameter parameter);

// Levels in a full factorial design; 1: it is fixed.
std::size_t level_count(const DesignSpace& space, Factor factor);

// The value at a share of the way, 0 to 1: of a range that far along it, of levels the one whose
// equal part of the way it falls in.
double value_at(const Values& values, double share);

// Moves what a candidate has on one factor to the value at the share.
void set_value(Pattern& pattern, const DesignSpace& space, Factor factor, double share);

// Combinations before any is left out, exact up to 2^53: levels multiplied, or samples.
double combination_count(const DesignSpace& space);

// What is wrong with the design, as a sentence without its full stop; empty if it can be run.
std::string design_fault(const DesignSpace& space);

}  // namespace tact
