// In which order to ask for pairs so that the map settles early, and whether it has.
//
// Not the publication's design: pairs are not asked in random order. Every pair still comes once a
// pass, so that whoever reaches the end has answered the full design's trials.
//
// Source    ours, from parts: cyclic designs of incomplete pairs (Spence & Domoney 1974), then the
//           pair that maps which fit equally well disagree on (query by committee: Seung, Opper &
//           Sompolinsky 1992), in later passes the pair that fits the map least. The pair whose
//           distance varies most over the maps is that of the most expected information, which is
//           log(1 + variance / noise) / 2 of noise that is normal and the same for all pairs
//           (Lindley 1956; MacKay 1992). Change of shape: K (model/map/alienation.h).
// Input     answers of one participant so far, in their order
// Valid     4 to 40 patterns; maps of two dimensions, which few answers can carry
// Exact     same answers, same pair, on any machine that computes alike.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/study/pairwise_study.h"

namespace tact {

inline constexpr std::size_t kMostAdaptivePatterns = 40;

struct RatedTrial {
    Trial trial;
    double similarity = 0.0;
};

// The next trial; none when all are answered. Attention pairs come where the plan has them.
std::optional<Trial> next_adaptive_trial(const TrialPlan& plan,
                                         std::span<const RatedTrial> answers);

// K between the map of all answers and the maps with fewer: `step` answers less each, the latest
// first.
struct MapSettling {
    std::vector<double> change;  // at most three
    bool is_settled = false;     // three small ones in a row: more trials would change little
};

inline constexpr double kSettledChange = 0.15;  // unrelated maps have about .5

MapSettling map_settling(std::size_t patterns, std::span<const RatedTrial> answers);

}  // namespace tact
