// What an actuator has been given over time, and what it may be given now: one account for plays in
// turn, loops, their changes, pauses and levels.
//
//     rms    over any second, of the drive as it left: what is to come is turned down until what
//            lies less than a second back leaves room for it
//     travel where a limit of it is known: what still moves from plays before adds up with what is
//            to come, which is turned down until both together stay within it (travel.h)
//     heat   where no limit is known: seconds of driving, less one for each second of rest. That is
//            a time constant of the drive's own limit, kLongestOnEndS (devices/device/protection.h)
//            unless a person says more. When it is used up, a play ends.
//
// Source    choices of ours
// Input     samples of -1..1, as they leave; what they are at level 1 of what is to come (Load)
// Exact     but for what lies within one block of 2 ms, which counts as spread evenly over it
// Left out  what a program that ran before gave the actuator. Controllers have no limits of rms and
//           travel: no calibration is of one.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "devices/device/travel.h"

namespace tact {

inline constexpr double kLedgerBlockS = 0.002;
inline constexpr std::size_t kLedgerBlocks = 500;  // the second that rms is of

// A plain value that a device owns; nothing here allocates.
struct Ledger {
    std::array<double, kLedgerBlocks> squares_s{};  // of full scale, of the last blocks, in turn
    std::size_t next = 0;                           // of them: the one to be written next
    double square_s = 0.0;                          // of the block that is under way ...
    double filled_s = 0.0;                          // ... and how long that is
    double driven_s = 0.0;                          // on end, less the rests since
    Motion motion{};                                // now, of all that was given
    double f0_hz = 0.0;                             // ... by the newest travel known

    bool operator==(const Ledger&) const = default;
};

// The squares of a drive at level 1, summed up to the end of each block.
struct Load {
    std::vector<double> sums_s{0.0};
    double length_s = 0.0;
};

Load load_of(std::span<const float> samples, double rate_hz);

// What the ledger has held back of a play, to be said of it; empty: nothing. `kept` of its level,
// `is_warm`: it ended early.
std::string words_on_held(double kept, bool is_warm);

// One sample has left. True: a block is complete.
bool note(Ledger& ledger, double sample, double duration_s, bool is_driven);

// So much of the drives that play, from one moment to another, at their mean levels meanwhile.
struct MotionStretch {
    const Travel* travel = nullptr;
    double from_s = 0.0;
    double to_s = 0.0;
    double level = 0.0;
};
void note_motion(Ledger& ledger, double duration_s, const MotionStretch& drive,
                 const MotionStretch& under);

// `driven_s` of a drive whose samples nobody counts, or a rest.
void note_driven(Ledger& ledger, double driven_s);
void note_rest(Ledger& ledger, double rest_s);

// Until a drive that may be driven for `rest_after_s` on end has to end, s.
double left_s(const Ledger& ledger, double rest_after_s);

// The largest level at which no second has more than `rms_limit` of what was given and of `load`,
// which continues at `from_s`; a limit of 0 is not known. Seconds of the load alone are held to the
// limit by its largest level, which is that of its repetition.
double allowed_level(const Ledger& ledger, const Load& load, double from_s, bool loop,
                     double rms_limit);

}  // namespace tact
