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
#include "model/dissimilarity/number_mark.h"

namespace tact {

// A pair that was not rated, a correlation that is not defined.
inline constexpr double kNoRating = std::numeric_limits<double>::quiet_NaN();

// One pass of one person through the pairs.
struct Judgement {
    std::string participant;        // the same for repetitions
    std::vector<double> condensed;  // NaN: not rated

    bool operator==(const Judgement&) const = default;
};

// What is known of a participant that decides whether they count (model/study/who_counts.h).
struct Standing {
    std::string participant;
    bool synthetic = false;  // nobody was asked
    bool rehearsal = false;  // nothing was felt
    std::string excluded{};  // why, as a phrase; empty: by nothing

    bool operator==(const Standing&) const = default;
};

struct RatingStudy {
    std::vector<std::string> labels;
    bool is_named = true;  // false: the labels are only positions
    std::vector<Judgement> judgements;
    std::vector<Standing> standings{};  // only of people with something to report
    std::string fingerprint{};  // of what was felt (model/set/set_ratings.h); empty: not known
    std::vector<std::string>
        versions{};                     // of each label (model/set/felt_versions.h); empty: as well
    std::vector<std::string> edited{};  // labels of patterns that are others than were felt
    std::vector<std::string> gone{};    // were rated; left out, as they are not in the set
    std::size_t left_out = 0;           // participants who do not count, and are not among these
    std::size_t rehearsals = 0;         // of those

    bool operator==(const RatingStudy&) const = default;
};

// "" of people alone; "nobody was asked" of simulated participants alone, "2 of 4 were simulated".
std::string words_on_simulated(const RatingStudy& study);

// Whether nobody was asked for some of the judgements.
bool is_partly_synthetic(const RatingStudy& study);

// The mark of every number made of these ratings.
NumberMark mark_of(const RatingStudy& study);

// A phrase on patterns that were edited or are gone since they were rated, with names: "edited
// since they were rated: "a", "b"". Empty for none.
std::string words_on_edited(const std::vector<std::string>& edited);
std::string words_on_gone(const std::vector<std::string>& gone);

// The study without what is not among the names, which then is `gone`.
RatingStudy without_gone(const RatingStudy& study, const std::vector<std::string>& names);

// The study of all these patterns in their order, with no ratings of those that it lacks. Errors: a
// rating of none of the patterns; of unnamed patterns, another number of them.
Expected<RatingStudy> spread_over(const RatingStudy& study, const std::vector<std::string>& names);

// Ratings of fewer patterns tell nothing of a map.
inline constexpr std::size_t kLeastRated = 3;

// The same for ratings that are to be used: of three of the patterns at least, or of all. Ratings
// of what is not among the patterns are left out (`gone`) where three others stay.
Expected<RatingStudy> matched(const RatingStudy& study, const std::vector<std::string>& names);

// Names of the patterns without any rated pair, in their order.
std::vector<std::string> unrated_patterns(const RatingStudy& study);

// A sentence on them without a full stop, with names and the number; empty for none. Where it is
// all of them, nobody counts, which is what it says.
std::string remark_on_unrated(const std::vector<std::string>& unrated, std::size_t patterns);

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
    // What the mean would have with the mean of as many others who felt the same, without noise:
    // the square root of its reliability. NaN below 0.
    double ceiling_of_mean = 0.0;
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

// Halves: every way to split the voices if at most 1,000 (12 voices), otherwise 1,000 drawn ones.
Reliability reliability(const RatingStudy& study);

}  // namespace tact
