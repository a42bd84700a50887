// A study as tidy CSV, an answer a line: R and Python read it in a line, and so does
// `tactspace compare --ratings`.
//
//     participant,trial,a,b,side,rating,replays,response_s,attention,<marks>
//     P1,1,low,high,a,54,1,6.2,0,0,0,0,1,,DualSense,0123456789abcdef,<UTC>,a
//
//     participant,round,asked_groups,group,pattern,response_s,<marks>      (of sorting)
//
//     <marks>: excluded,synthetic,rehearsal,whole,why,device,fingerprint,at
//
// and of pairs felt_first after them: a, b or NA where it is not known.
//
// `a` comes before `b` in the set; `side` tells which of them was on the left; `rating` is the
// similarity, 0 to 100, as it was given; `replays` counts what was felt more than once. `excluded`
// is the participant, or what was not felt whole, `why` for which reason; `rehearsal` is 1 where
// nothing was felt, `whole` 0 where a side was not felt whole; `fingerprint` is that of the
// patterns felt. Where participants are scaled, two more columns say how, and the scaled
// similarity, which is what compare then takes: scaling,scaled.
#pragma once

#include <iosfwd>
#include <span>

#include "model/study/study_results.h"

namespace tact {

enum class StudyRows { counted, everyone };

// Records of one study, as study_results() took them.
void write_study_csv(std::ostream& stream, std::span<const StudyRecord> records,
                     const StudyResults& results, StudyRows rows);

}  // namespace tact
