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
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/signal/waveform.h"

namespace tact {

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

}  // namespace tact
