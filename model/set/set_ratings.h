// What people said of a set's patterns: as kept with the set, and as a study of its patterns.
//
// Input     ratings by the names of the patterns; patterns that nobody rated are missing
// Exact     a study kept with its set comes back as it was, in the order of the set's patterns;
//           from more than kMostKeptRatings passes each participant's mean is kept, which says the
//           same.
#pragma once

#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"

namespace tact {

inline constexpr std::size_t kMostKeptRatings = 1000;  // of a set file

// `file`: where the study was read from; may be empty. Who was not asked is marked so, and how many
// are left out stays known.
std::vector<Ratings> kept_ratings(const RatingStudy& study, const std::string& file);

// The ratings of a set as a study in the order of its patterns, with patterns edited since, removed
// and left out. Errors: no ratings, ratings of other patterns, or of fewer than three.
Expected<RatingStudy> study_of(const PatternSet& set);

// What a study takes from a set: which patterns, and a fingerprint of what is felt.

// Fingerprint of the names and waveforms of the patterns that take part, as 16 hexadecimal digits.
// Another amplitude is another study.
std::string study_fingerprint(const PatternSet& set, const std::vector<std::string>& names);

// Names of the patterns that take part, in the order of the set; those that are gone are left out.
std::vector<std::string> study_patterns(const PatternSet& set);

}  // namespace tact
