// Answers as other programs write them, turned into this program's own table: columns a, b and
// rating, and participant where there is one.
//
//     stimA,stimB,slider.response,participant      participant,a-b,a-c,b-c
//     low.wav,high.wav,80,p01                      p01,80,45,60
//
// Input     records of which the first names the columns, under names that experiments use
//           (PsychoPy, jsPsych, also its array of two in `stimulus`), in any case; or a column for
//           each pair, or a table that is this program's already
// Output    the same records where nothing is foreign; a remark for whatever was taken as what
// Left out  names in other languages than English
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/io/people/rating_scale.h"
#include "model/table/table.h"
#include "model/text/csv.h"

namespace tact {

// What somebody says of a table of answers; an empty column goes by its usual names.
struct AnswerColumns {
    std::string a, b, rating, participant;
    TableHints written;

    bool operator==(const AnswerColumns&) const = default;
};

// From "a=stimA,b=stimB,rating=slider.response,participant=pid": any of them, once.
Expected<AnswerColumns> answer_columns(std::string_view text);

// The places of the columns that are read, from 0, by what somebody says and by their usual names.
struct AnswerPlaces {
    std::optional<std::size_t> a, b, rating, participant;

    bool operator==(const AnswerPlaces&) const = default;
};

// All are empty where a named column is not there.
AnswerPlaces answer_places(std::span<const std::string> head, const AnswerColumns& named);

struct OwnAnswers {
    std::vector<CsvRecord> records;
    std::string fault;                 // a named column that is not there; then nothing else counts
    std::vector<std::string> remarks;  // sentences without a full stop
    RatingScale scale = RatingScale::guess;  // as the name of the column says it
};

OwnAnswers own_answers(std::vector<CsvRecord> records, const TableDialect& dialect,
                       const AnswerColumns& named = {});

}  // namespace tact
