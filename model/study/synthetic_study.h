// A whole study answered by a synthetic rater: every trial, or every round of sorting.
//
// Source    sorting: average linkage (Sokal & Michener 1958) of the rater's noisy dissimilarities;
//           the free round makes as many groups as a fifth of their range parts.
// Output    a record that says it is synthetic, without times of day
// Exact     same rater and header, same record.
#pragma once

#include <cstdint>

#include "model/dissimilarity/dissimilarity.h"
#include "model/study/pairwise_study.h"
#include "model/study/study_record.h"

namespace tact {

// Simulated participants: ratings made from a given matrix, for testing and teaching.
//
// Source    ours: similarity = 100 (1 - d / largest d) + bias + noise, whole numbers from 0 to 100.
//           A lapse (of a person who does not attend) is any number, whatever the pair.
// Output    whole numbers, as a slider gives them; identical patterns have d = 0, no bias and, as
//           the same is easily felt, 0.3 of the noise
// Valid     NaN pairs are rated as the mean of the others
// Left out  fatigue, learning, order and side effects, other uses of the scale.
// Exact     same input, same numbers, on any machine: by participant, pair and pass.

struct SyntheticRaterParams {
    double noise = 10.0;       // standard deviation of a rating, points of 100
    double bias = 0.0;         // points added to every similarity of different patterns ...
    double bias_spread = 5.0;  // ... with so much (sd) between participants
    double lapses = 0.0;       // share of trials answered blindly, 0..1
    std::uint64_t seed = 1;    // of the crowd
};

struct SyntheticRater {
    SyntheticRaterParams params;
    Dissimilarity truth;
    std::uint64_t number = 0;  // of the participant
};

// Similarity 0..100 that the rater gives in a trial; `serial` tells repetitions apart.
double rating_of(const SyntheticRater& rater, const Trial& trial, std::uint64_t serial);

// The seconds that the answer took them: 3 and more.
double response_s_of(const SyntheticRater& rater, std::uint64_t serial);

// `header` as of a person; the truth has the patterns of the header, in their order.
StudyRecord simulated_study(StudyHeader header, const SyntheticRater& rater);

// `wanted` groups; 0: where joining would bridge more than a fifth of the range.
Sorting average_linkage(const Dissimilarity& dissimilarity, std::size_t wanted);

}  // namespace tact
