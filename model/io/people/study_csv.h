// A study as tidy CSV, an answer a line: R and Python read it in a line, and so does
// `tactspace compare --ratings`.
//
//     participant,trial,a,b,side,rating,replays,response_s,attention,excluded,synthetic
//     P1,1,low,high,a,54,1,6.2,0,0,0
//
//     participant,round,asked_groups,group,pattern,response_s,excluded,synthetic      (of sorting)
//
// `a` comes before `b` in the set; `side` tells which of them was on the left; `rating` is the
// similarity, 0 to 100; `replays` counts what was felt more than once.
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
