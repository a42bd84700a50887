// What an actuator makes of a drive signal: a table of g per full scale, and its use.
//
// Between measured frequencies log S is linear in log f. The drive of a waveform is the waveform
// divided by the response, frequency by frequency, without delay:
//     H(f) = 1 / max(S(f), S_max / 10)        (20 dB of boost at most: more would tear at the coil)
// and 0 beyond a third of an octave outside the table, with a soft edge on the way there, and
// between the known points around those that are not known, with that edge outside. A drive
// that is no loop and would end above 2 % of its peak ends in a ramp of 5 ms.
//
// Source    linear interpolation of log-log responses and regularised inversion are common
// practice;
//           the limits are choices of ours
// Input     a waveform in g
// Output    a drive signal of -1..1 where the actuator can follow
// Left out  phase: the response is taken to have none of its own, so that onsets may be smeared by
//           a resonance; heating beyond one second; what the filter rings before the first sample.
// Exact     same input, same bits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/device/device.h"
#include "model/signal/waveform.h"

namespace tact {

// The response at one frequency.
struct ResponsePoint {
    double frequency_hz = 0.0;
    double g_per_full_scale = 0.0;
    double largest_drive =
        1.0;           // up to which it was measured, of full scale, above 0; no more is sent
    double thd = 0.0;  // total harmonic distortion there: second to fifth, as a share
    double nonlinearity = 0.0;  // largest departure from proportional over the levels, as a share
    bool between = false;       // worked out from the points around it, not measured
    bool unknown = false;       // out of proportion at all levels: nothing is sent around it

    bool operator==(const ResponsePoint&) const = default;
};

// Response of one actuator on one channel, with its amplifier and as it was mounted.
struct Calibration {
    std::string device;  // its id (devices/device/device.h)
    int channel = 1;
    std::string actuator;   // "Haptuator, left"
    std::string mounting;   // how it was held or fixed
    std::string gain_note;  // of amplifier and mixer: another setting makes it invalid
    std::string sensor;
    std::string date;  // YYYY-MM-DD
    double load_mass_g = 0.0;
    std::vector<ResponsePoint> points;  // frequencies rise; at least one
    double excursion_limit_mm = 0.0;    // peak; 0: not known
    double rms_limit = 0.0;             // of the drive over any second; 0: not known

    bool operator==(const Calibration&) const = default;
};

// Why a calibration is not of this channel of a device: a sentence without a full stop, empty where
// it may be. One that names no device is taken to be of any.
std::string calibration_mismatch(const Calibration& calibration, const DeviceInfo& device,
                                 int channel);

// g per full scale; none farther than a third of an octave from what was measured.
std::optional<double> response_g(const Calibration& calibration, double frequency_hz);

// All at level 1. The samples of the drive are what the waveform asks for; its largest level is the
// one at which the first of the actuator's limits is met, and the device holds all of it back to
// that: a pattern that is bent would be another.
struct CalibratedDrive {
    Drive drive;
    double peak = 0.0;          // of full scale; above 1 it would be cut
    double excursion_mm = 0.0;  // peak, down to the slowest that the table reaches; with a limit of
                                // it also from rest, and stopped at any moment
    double rms = 0.0;           // of the loudest second of its repetition, looped or not: plays
                                // in turn may follow at once
    double over_measured = 0.0;  // peak, each frequency as a share of the largest drive measured
                                 // there; 0: measured up to full scale
    double share_lost = 0.0;     // of the energy meant: outside the table, or boosted too little
    std::vector<std::string> warnings;  // sentences without a full stop

    bool operator==(const CalibratedDrive&) const = default;
};

// `loop`: the limits are those of its endless repetition. `longest_s`: on end; default: for ever
// where an rms limit knows the heat, kLongestOnEndS (devices/device/protection.h) where nothing
// does.
CalibratedDrive calibrated_drive(const Waveform& waveform, const Calibration& calibration,
                                 bool loop = false, std::optional<double> longest_s = {});

// What the actuator makes of a drive signal, in g, as long as it; nothing beyond the table's reach.
std::vector<double> acceleration_g(const Drive& drive, const Calibration& calibration);

// Slower is drift of a sensor, unless a table was measured there.
inline constexpr double kLowestMotionHz = 10.0;

// The largest displacement of a waveform around its mean, from `lowest_hz` up.
double peak_displacement_mm(const Waveform& waveform, double lowest_hz = kLowestMotionHz);

}  // namespace tact
