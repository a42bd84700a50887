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
#pragma once

#include <cstddef>

namespace tact {

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
