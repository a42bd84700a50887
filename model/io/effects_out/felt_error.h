// What a difference of amplitude and frequency is worth to who feels it, in dB: by this points are
// chosen where a format has too few of them.
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

#include <string>

namespace tact {

struct FeltTone {
    double amplitude_g = 0.0;
    double frequency_hz = 150.0;
};

// 0 for what nobody can tell apart, rounding included.
double felt_error_db(const FeltTone& asked, const FeltTone& got);

// "2.1 dB off where it is felt (0.03 of full scale)", "0.03 of full scale off, which nobody feels".
std::string felt_words(double error_db, const std::string& numbers);

}  // namespace tact
