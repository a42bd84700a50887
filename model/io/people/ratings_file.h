// Ratings as people collect them, one file or several.
//
//     ,a,b,c         0 30 55       participant,a,b,rating      30,55,20
//     a,0,30,55      30 0 20       P1,low,high,80              25,60,15
//     b,30,0,20      55 20 0       P1,low,mid,45
//     c,55,20,0
//
//     a square with names; a bare one; a line a rating, with participants or without; condensed, a
//     row a participant (or one column: the mean)
//
// Source    quoting as in RFC 4180
// Input     a cell that is empty, "NaN", "NA" or "-" is a pair that was not rated. Both triangles
//           of a square count: their mean, or the one that is known. A pair that a participant
//           rated again is a repetition. A file without participants is one participant, by its
//           name.
// Output    dissimilarities; of similarities from 0 to 100, 100 minus each. Errors as
//           "FILE:LINE: expected .."
//           The columns excluded, synthetic, rehearsal, whole, why, fingerprint and scaled, as
//           model/io/people/study_csv.h writes them, are heeded; so is its form of sortings.
// Output    only those who count (model/study/who_counts.h), unless nobody does: then an Error
// Valid     at most 500 patterns, 1,000 participants and 100 ratings of a pair by each
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/io/people/foreign_answers.h"
#include "model/io/people/rating_scale.h"
#include "model/study/who_counts.h"

namespace tact {

// The table of a study's report that has the answers (study_csv.h).
inline constexpr const char* kAnswersFile = "answers.csv";

struct LoadedRatings {
    RatingStudy study;                         // of those who count
    std::vector<std::string> remarks;          // sentences: what was guessed, averaged, left out
    std::vector<LeftOutParticipant> left_out;  // as the remarks say, too
};

Expected<LoadedRatings> parse_ratings(std::string_view text, const std::string& file,
                                      RatingScale scale, const CountRule& who = {},
                                      const AnswerColumns& columns = {});

// Several files as one study of the first one's patterns; a folder stands for its .csv and .txt
// files, or of a study's report for kAnswersFile. The scale is guessed of all together. Or
// participants' files of a study (study_file.h), and folders of them, which say all by themselves.
Expected<LoadedRatings> read_ratings(std::span<const std::filesystem::path> paths,
                                     RatingScale scale, const CountRule& who = {},
                                     const AnswerColumns& columns = {});

}  // namespace tact
