// How alike people rate, in the numbers that other fields expect; and whether the order in which a
// pair was felt, or its sides, or practice, shift ratings.
//
// Source    ICC(2,1) and ICC(3,k): Shrout & Fleiss 1979; their intervals: McGraw & Wong 1996.
//           Krippendorff's alpha of interval data: Krippendorff 2011. Order and sides: a
//           randomisation test (Fisher 1935): the sides were drawn; who feels the left first, as
//           most do, draws the order by them.
// Input     means over each person's repetitions; NaN: not rated
// Output    NaN where it is not defined: of fewer than two people or pairs, or without variance
// Valid     intervals are of normal ratings and of pairs that are independent, which pairs of one
//           pattern are not: theirs is a lower bound of the width
// Left out  weights, nominal and ordinal forms of alpha, ICC of pairs that some did not rate (those
//           pairs are left out of it, and counted)
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "model/common/distributions.h"
#include "model/study/ratings.h"
#include "model/study/study_record.h"

namespace tact {

struct Icc {
    double value = 0.0;
    Interval interval;  // 95 %
};

struct InterRater {
    std::size_t people = 0;
    std::size_t pairs = 0;        // rated by all of them: those of the ICC
    Icc single;                   // ICC(2,1): absolute agreement of one person with another
    Icc mean;                     // ICC(3,k): consistency of the mean of all `people`
    double alpha = 0.0;           // Krippendorff's, of all pairs rated by two at least
    std::size_t alpha_pairs = 0;  // of alpha
};

InterRater inter_rater(const RatingStudy& study);

// Both ICC of a table: a row a pair, a column a person, all known, row after row.
Icc icc_single(std::span<const double> table, std::size_t people);
Icc icc_mean(std::span<const double> table, std::size_t people);

// A rating one way round against the other, within each person and pair.
struct Shift {
    std::size_t people = 0;       // with ratings both ways
    std::size_t comparisons = 0;  // person and pair
    double mean = 0.0;            // points of similarity: first way less second
    double p = 1.0;               // two-sided; see each. NaN: no signs could change the number
    std::size_t signs = 0;        // ways to draw the signs that were counted
    bool is_exact = false;        // those are all there are
};

struct OrderEffects {
    // The pattern that is earlier in the set felt first, less felt second; on the left, less on the
    // right. p: how often drawn orders make the pairs' own shifts as large: the sum over pairs of
    // the squared mean shift, each by how many people have it.
    Shift felt_first;  // only of trials of which it is known
    Shift side;
    // Last pass less first. p: how often the mean over people is as far from zero when the sign of
    // each person is drawn.
    Shift practice;
};

// Number of signs drawn if there are more ways; fewer ways are all counted.
inline constexpr std::size_t kOrderDraws = 5000;

// "5,000 drawn signs" or "all 256 signs"; where there is no p, the reason.
std::string signs_text(const Shift& shift);

// Records are pairwise, of participants who count (elsewhere `excluded` of each summary says who
// does): all are used. Answers that were not felt whole are ignored.
OrderEffects order_effects(std::span<const StudyRecord> records);

}  // namespace tact
