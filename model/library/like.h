// Which of a library feel most like a vibration, or can take its place on another device: what
// comes back of each from the files of an export is held against what was meant.
//
// Source    ours; PM of a row: model/library/likeness.h, what comes back: model/export
// Valid     at most kMaxSetSamples compared in all; with more, an Error says to narrow the search
// Left out  what the device makes of its files: devices/calibration
// Exact     same input, same bits, on any number of threads
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/common/expected.h"
#include "model/export/export_target.h"
#include "model/library/library.h"
#include "model/library/likeness.h"

namespace tact {

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
