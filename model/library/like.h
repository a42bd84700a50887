// Which of a library feel most like a vibration, or can take its place on another device: what
// comes back of each from the files of an export is held against what was meant.
//
// Source    ours; what comes back: model/export
// Valid     at most kMaxSetSamples compared in all; with more, an Error says to narrow the search
// Left out  what the device makes of its files: devices/calibration
// Exact     same input, same bits, on any number of threads
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/common/expected.h"
#include "model/export/export_target.h"
#include "model/library/library.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/signal/waveform.h"

namespace tact {

// What feels like this: one vibration held against many, each pair as a set of the two alone would
// have it, and ordered by PM.
//
//     PM_j = w_NC rank(NC_j) + w_OC rank(OC_j)        ranks among these comparisons alone
//
// So PM orders the row; its size says how many are nearer, and not how far apart two feel. A pair
// is compared at its own length, the longer of the two: in a set all would be filled up to the
// longest, and a tick among seconds of something else is felt by no receptor. So nothing changes
// for a pair when others come or go, but its rank.
//
// Source    Lim & Park 2023, section 5.3; asking for one row is ours
// Valid     what lasts longer than kLongestTimes the one in question, and kLongestAlwaysS, feels
//           like another thing: it is left out
// Exact     same input, same bits, on any number of threads

inline constexpr double kLongestTimes = 4.0;
inline constexpr double kLongestAlwaysS = 1.0;

// Whether a vibration of this length is short enough to be held against one of that.
bool is_comparable(double duration_s, double with_duration_s);

struct LikenessOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

struct LikenessRow {
    std::vector<double> nc;
    std::vector<double> oc;
    std::vector<double> pm;
    std::vector<bool> felt;      // by any receptor, filled up to the pair's length
    bool is_wanted_felt = true;  // by itself

    bool operator==(const LikenessRow&) const = default;
};

// None when stopped.
std::optional<LikenessRow> likeness_row(const Waveform& wanted, std::span<const Waveform> others,
                                        const PerceptualModelParams& params,
                                        const LikenessOptions& options = {});

struct LikeQuestion {
    Vibration wanted{};
    std::vector<std::size_t> among{};      // places of entries, ascending
    std::optional<ExportTarget> target{};  // none: as they are
    PerceptualModelParams model{};
};

struct LikeHit {
    std::size_t entry = 0;
    double pm = 0.0;
    double nc = 0.0;
    double oc = 0.0;
    bool is_felt = true;

    bool operator==(const LikeHit&) const = default;
};

struct LikeAnswer {
    bool is_wanted_felt = true;       // or what is like it is so by rhythm alone
    std::vector<LikeHit> hits;        // the nearest first; of equals as the library has them
    std::optional<LikeHit> exported;  // the wanted one as the target has it; `entry` says nothing
    // Left out.
    std::vector<std::size_t> too_long;
    std::vector<std::size_t> not_held;  // recordings, where the target holds none
    std::vector<std::string> unread;    // why, each as "FILE: what was expected"
};

// How many are nearer than what comes back of the wanted one itself; 0 where nothing does.
std::size_t nearer_than_exported(const LikeAnswer& answer);

inline constexpr const char* kLikeStopped = "stopped before all were compared";

Expected<LikeAnswer> most_alike(const Library& library, const LikeQuestion& question,
                                const LikenessOptions& options = {});

}  // namespace tact
