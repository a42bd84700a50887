// From tones measured at several levels to one strength a frequency: that of small signals.
//
// An actuator follows its drive up to some acceleration, and less and less beyond. At each
// frequency the levels that are in proportion to the lowest, to 12 %, are taken; the strength is
// that of the highest of them, or the greatest where one is greater than noise explains.
//
// Where the lowest two are out of proportion already, weaker drives are told by the softest limit
//     f(A) = S A / (1 + S A / a):  S = S_1 (1 + y),  y = (1/r - 1) / (q - 1/r),
// r = S_2 / S_1, q = level 2 / level 1. A harder limit has a smaller S, S_1 at least: so nothing is
// driven too strongly. Where S would be more than 4 dB above S_1 it is not known, and nothing is
// sent there. Where they agree to 12 %, that limit has S at most 8 % above S_1.
//
// Source    the limits are choices of ours
// Input     tones of one plan; with less error than noise allows, others are not looked at
// Left out  limits softer than that; what follows its drive less at low levels only (friction) but
//           for leaving it out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/calibration_run.h"

namespace tact {

// What was measured at one frequency.
struct MeasuredPoint {
    ResponsePoint point;                 // says so where it is not known
    CalibrationTone tone;                // by which it was measured
    std::vector<MeasuredTone> clear;     // all that noise leaves, levels rise
    std::vector<MeasuredTone> followed;  // of them, the lowest, those that are in proportion
    double raised = 1.0;                 // times as strong as the lowest level was
};

inline constexpr double kMostToneError = 0.03;  // standard error of an amplitude: 0.26 dB

// Frequencies rise.
std::vector<MeasuredPoint> in_proportion(const std::vector<MeasuredTone>& tones);

double strength(const MeasuredTone& one);  // g per full scale

// The strength of weaker drives over that of the lowest level, by the softest limit. None: there is
// no such limit, or more than 4 dB.
std::optional<double> raised_by(const MeasuredTone& lowest, const MeasuredTone& next);

// Sentences without a full stop.
std::vector<std::string> words_on_proportion(const std::vector<MeasuredPoint>& measured);

}  // namespace tact
