// Curves in g and Hz as the shares, 0 to 1, that an actuator map makes them of: the readers' way,
// backwards.
//
// What is louder than full scale scales the whole pattern down, so that its parts keep their
// strengths beside each other. What lies outside of the map's band is moved to its nearer end. A
// transient gets the frequency that is nearest, and the intensity that makes its energy equal,
// where the map's burst is longer or shorter or of another shape.
//
// Source    model/io/effects/actuator_map.h
// Output    exact where the map's laws are linear; otherwise straight lines within 0.1 %
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/io/effects/actuator_map.h"
#include "model/io/effects_out/plain_curves.h"

namespace tact {

struct TapShares {
    double time_s = 0.0;
    double amplitude = 0.0;
    double frequency = 0.0;
};

struct Shares {
    double duration_s = 0.0;
    AmplitudeCurve amplitude;
    AmplitudeCurve frequency;     // at least one point
    std::vector<TapShares> taps;  // by time
};

// Intensity of a share of the map's full scale; 0 if the map has no full scale.
double intensity_01(const ActuatorMap& map, double share_of_full_scale);

// Share of the map's band; the middle if the band is a single frequency.
double frequency_01(const ActuatorMap& map, double hz);

// What multiplies all, at most 1, so that the loudest is full scale; `loudest` is a share of it.
double scale_to_full(double loudest, std::vector<std::string>& remarks);

// Moved into the band, said in words.
FrequencyCurve in_band(FrequencyCurve curve, Range band_hz, std::vector<std::string>& remarks);

// The integral of the squared waveform, g^2 s. It leaves out the phase of the last period and a
// sine's flanks, so only ratios between transients of one shape are exact.
double energy_g2_s(const Transient& transient);

Shares as_shares(const PlainCurves& curves, const ActuatorMap& map, WrittenEffect& written);

// Keeps at most `most` points of each curve, those that are felt first.
void thin_shares(Shares& shares, std::size_t most, const ActuatorMap& map,
                 std::vector<std::string>& coarse);

// Keeps at most `most` taps, the strongest.
void keep_strongest(std::vector<TapShares>& taps, std::size_t most,
                    std::vector<std::string>& remarks);

// "150 Hz left out: the device has its own frequency".
void remark_left_out_hz(const FrequencyCurve& curve, std::vector<std::string>& remarks);

// "1 transient", "3 transients".
std::string transients_text(std::size_t count);

// How many transients differ from what was asked for, and the first of them: "3 transients: another
// length, the first 22 ms in place of 10".
struct Changes {
    std::size_t count = 0;
    double from = 0.0;
    double to = 0.0;

    void note(double asked, double got, double tolerance);
    void remark(const std::string& what, const std::string& unit,
                std::vector<std::string>& remarks) const;
};

// What a difference of amplitude and frequency is worth to who feels it, in dB: by this points are
// chosen where a format has too few of them, and by this an export is judged.
//
// Strength is the level above the detection threshold at the frequency, and 0 below: an error in
// what nobody feels costs nothing, near threshold it is relative to what is left of it. Weber's
// fractions are near a fifth for amplitude and for frequency alike, at any level: so dB of strength
// count as much as dB of the frequencies' ratio, which count where both are felt.
//
// Source    thresholds: model/physiology's default tables; Weber's fractions: Israr et al. 2006
// Valid     continuous vibration of one frequency; outside of the tables' range nothing is felt
// Left out  masking by what is before and beside it; the tables of a set's own model.

// The most points of a curve that are weighed by it where fewer may be written: it is costly.
inline constexpr std::size_t kMostWeighed = 4000;

struct FeltTone {
    double amplitude_g = 0.0;
    double frequency_hz = 150.0;
};

// dB above the detection threshold; 0 at and below it.
double felt_level_db(const FeltTone& tone);

// 0 for what nobody can tell apart, rounding included.
double felt_error_db(const FeltTone& asked, const FeltTone& got);

}  // namespace tact
