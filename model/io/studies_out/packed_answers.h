// Answers that a packed study brought back, as participants' records: who counts is then decided as
// of anybody who was asked here.
//
//     participant,trial,a,b,side,rating,response_s,attention,plays_left,plays_right,felt_first,
//     at,device,fingerprint,synthetic
//
// Input     CSV with these columns in any order, others passed over; participant, a, b, side and
//           rating are needed. `a` and `b` are names of patterns, `side` which of them was left
// Output    a record a participant, its answers in the order of `trial`. Errors as
//           "FILE:LINE: expected .."
// Exact     same input, same records.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/study/study_record.h"

namespace tact {

// `header`: of the study as it was packed; each participant's own are filled in.
Expected<std::vector<StudyRecord>> packed_answers(std::string_view text, const std::string& file,
                                                  const StudyHeader& header);

}  // namespace tact
