// What people said of how unlike the pairs of a set feel, and how far it can be relied on.
//
// Source    Spearman 1910, Brown 1910 (reliability of the mean from its halves); procedure: Lim &
//           Park 2023, section 6.1.
// Input     dissimilarities; NaN where a pair was not rated
// Left out  scaling of participants (the source does none), cluster sorting.
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"

namespace tact {

// A pair that was not rated, a correlation that is not defined.
inline constexpr double kNoRating = std::numeric_limits<double>::quiet_NaN();

// One pass of one person through the pairs.
struct Judgement {
    std::string participant;        // the same for repetitions
    std::vector<double> condensed;  // NaN: not rated

    bool operator==(const Judgement&) const = default;
};

struct RatingStudy {
    std::vector<std::string> labels;
    bool is_named = true;  // false: the labels are only positions
    std::vector<Judgement> judgements;

    bool operator==(const RatingStudy&) const = default;
};

// The study with its patterns in the order of `names`. Errors: a pattern without ratings, a rating
// of none of the patterns; of unnamed patterns, another number of them.
Expected<RatingStudy> matched(const RatingStudy& study, const std::vector<std::string>& names);

// The mean over repetitions, then over participants, of those who rated the pair; NaN where nobody
// did.
Dissimilarity mean_ratings(const RatingStudy& study);

// How alike people, or the repetitions of a single person, are. NaN with fewer than two.
struct Reliability {
    std::size_t voices = 0;  // participants, or repetitions of the only one
    bool is_of_one_person = false;
    double half_rho = 0.0;         // mean Spearman between the means of two halves
    double spearman_brown = 0.0;   // 2 r / (1 + r): of the mean of all
    double one_with_others = 0.0;  // mean Spearman of one voice with the mean of the others
};

// How one participant agrees with the mean of the others: Spearman's rho, NaN where undefined. In
// the order in which they came; none of fewer than two.
struct VoiceAgreement {
    std::string participant;
    double rho = 0.0;
};
std::vector<VoiceAgreement> agreement_with_others(const RatingStudy& study);

// Each participant's own mean over repetitions, in the order in which they came.
std::vector<Judgement> participant_means(const RatingStudy& study);

// Halves: every way to part them where that is at most 1,000 (12 voices), else 1,000 drawn ones.
Reliability reliability(const RatingStudy& study);

}  // namespace tact
