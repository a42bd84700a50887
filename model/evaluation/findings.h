// What the publication says comes out, checked one by one on what this program predicts.
//
// Source    assets/reference/qualitative_checks.csv: orderings in the text of Lim & Park 2023 and
// the
//           abstracts of its data sources
// Valid     soft checks of direction, not a validation: PM was never fitted to them here
// Left out  whatever needs ratings or exact stimuli that are not public; each such finding says so.
// Exact     same input, same bits.
#pragma once

#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"

namespace tact {

enum class FindingStatus {
    holds,
    fails,
    needs_ratings,  // is about people's ratings, which are not public
    needs_stimuli   // the exact vibrations are not public
};

struct Finding {
    std::string id;      // AM-1
    std::string set;     // ParkChoi2011
    std::string claim;   // as the table states it
    std::string source;  // where the publication says so
    FindingStatus status = FindingStatus::needs_ratings;
    std::string evidence;  // the numbers, or why they are missing
};

struct PredictedSet {
    PatternSet set;
    Dissimilarity pm;
};

// The sets whose stimuli are known exactly, under PM.
struct KnownSets {
    PredictedSet am_4hz;  // Park & Choi 2011 as in the publication's caption
    PredictedSet am_5hz;  // as in its authors' files
    PredictedSet twelve;  // Lim & Park 2023, section 6.1
};

// Their names below assets/sets.
inline constexpr const char* kAm4HzSet = "park_choi_2011_am_4hz";
inline constexpr const char* kAm5HzSet = "park_choi_2011_am_5hz";
inline constexpr const char* kTwelveSet = "pm_2023_twelve";

// All findings of the table, in its order.
std::vector<Finding> findings(const KnownSets& sets);

}  // namespace tact
