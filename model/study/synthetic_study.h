// A whole study answered by a synthetic rater: every trial, or every round of sorting.
//
// Source    sorting: average linkage (Sokal & Michener 1958) of the rater's noisy dissimilarities;
//           the free round makes as many groups as a fifth of their range parts.
// Output    a record that says it is synthetic, without times of day
// Exact     same rater and header, same record.
#pragma once

#include "model/study/study_record.h"
#include "model/study/synthetic_rater.h"

namespace tact {

// `header` as of a person; the truth has the patterns of the header, in their order.
StudyRecord simulated_study(StudyHeader header, const SyntheticRater& rater);

// `wanted` groups; 0: where joining would bridge more than a fifth of the range.
Sorting average_linkage(const Dissimilarity& dissimilarity, std::size_t wanted);

}  // namespace tact
