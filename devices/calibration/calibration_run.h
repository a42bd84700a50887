// Measuring an actuator: the signal to play, and the table that a recording of it gives.
//
// Stepped   a tone at each frequency and level; what it did while it settled is left out
// Sweep     a sine whose frequency rises evenly in octaves, once a level; each frequency counts for
//           a twelfth of an octave around it
//
// By least squares over a tone's settled part, with its phase p known at every sample:
//     x[n] = c + sum_{h=1..5} (a_h cos h p[n] + b_h sin h p[n]) + rest
//     S = sqrt(a_1^2 + b_1^2) / level,  THD = sqrt(sum_{h>1} a_h^2 + b_h^2) / fundamental,
//     SNR = 10 log10(power of the fundamental / power of the rest)
//     standard error of S = 1 / sqrt(SNR N / 2), as a share: white noise, and half of it to spare
//
// The table is made finer where a straight line between two points would err (resonance.h).
//
// Source    THD < 10 % and an error < 3 % (0.26 dB) to be taken: a choice of ours
// Input     a recording in g at the plan's rate, begun before the plan and ended after it
//           The recording's clock is told by the signal, which is known: what it is off is told
//           and taken out.
// Left out  phase; several sensors; a clock that drifts; a sweep's by a clock that is off.
// Exact     same input, same table.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "devices/calibration/calibration.h"
#include "model/common/expected.h"

namespace tact {

struct CalibrationParams {
    bool is_sweep = false;
    double low_hz = 20.0;
    double high_hz = 500.0;
    int per_octave = 6;  // at the least: steps are equal, and the last is high_hz
    std::vector<double> levels = {0.1, 0.3, 0.6};  // of full scale
    double tone_s = 0.6;  // all tones of the default take 53 s: recordings may last a minute
    double settle_s = 0.2;
    double sweep_s = 18.0;                                   // each; all three take 55 s
    std::vector<double> sweep_levels = {0.0375, 0.15, 0.6};  // one after the other, rising

    bool operator==(const CalibrationParams&) const = default;
};

// A part of the plan that measures one frequency at one level.
struct CalibrationTone {
    double frequency_hz = 0.0;
    double level = 0.0;
    std::size_t begin = 0;  // settled samples
    std::size_t end = 0;

    bool operator==(const CalibrationTone&) const = default;
};

// Begins with a burst that a recording is aligned by.
struct CalibrationPlan {
    Drive drive;
    std::vector<double> phase_rad;  // of the sine at every sample
    std::vector<CalibrationTone> tones;
    bool is_sweep = false;
};

CalibrationPlan calibration_plan(const CalibrationParams& params);

struct MeasuredTone {
    CalibrationTone tone;
    double amplitude_g = 0.0;
    double thd = 0.0;
    double snr_db = 0.0;
    double standard_error = 0.0;  // of the amplitude, as a share of it
    bool accepted = false;
};

struct CalibrationResult {
    std::vector<ResponsePoint> points;  // of accepted tones, one a frequency, at its highest level,
                                        // and those worked out between them
    std::vector<MeasuredTone> tones;
    double begins_s = 0.0;   // of the plan, in the recording
    double clock_off = 0.0;  // of the recording, as a share; above 0: all was too high
    // Sentences without a full stop: tones that were left out, and where the table may be wrong.
    std::vector<std::string> remarks;
};

// Why a tone is not accepted: "10 % of ... or more, or ...", by the limits that it is held to.
std::string words_on_left_out();

// Errors: a recording of another rate, or shorter than the plan; no sign of the plan in it; no tone
// good enough.
Expected<CalibrationResult> calibration_from(const CalibrationPlan& plan, const Waveform& recorded);

// ... of the signal that these parameters make, or made: a sweep once had one level, of 20 s.
Expected<CalibrationResult> calibration_from(const CalibrationParams& params,
                                             const Waveform& recorded);

}  // namespace tact
