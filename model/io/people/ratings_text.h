// One text of ratings in any of the forms that ratings_file.h names, before it is known which way
// its numbers run.
//
// Output    errors as "FILE:LINE: expected .."
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/io/people/foreign_answers.h"
#include "model/io/people/rating_scale.h"
#include "model/study/ratings.h"
#include "model/text/csv.h"

namespace tact {

inline constexpr std::size_t kMaxRatedPatterns = 500;  // nobody rates more: 124,750 pairs
// As many as a study of this program can have.
inline constexpr std::size_t kMaxParticipants = 1000;
inline constexpr std::size_t kMaxPasses = 100;

// What the numbers of a study take in memory beyond those of its text: each pass through the pairs
// has a place for every pair, rated or not.
inline constexpr std::size_t kMostUnratedCells = 25'000'000;

// What is wrong with this many passes through the pairs of n patterns in a text of this size, or
// empty. It is asked before memory for them is taken.
std::string passes_fault(std::size_t passes, std::size_t patterns, std::size_t text_bytes);

struct RatingsText {
    std::string file;
    RatingStudy study;              // participants as the text names them, or ""
    std::vector<double> identical;  // ratings of a pattern with itself
    // As a study of this program says it: no guess is needed.
    RatingScale scale = RatingScale::guess;
    bool is_scaled = false;              // similarities of each participant brought to one scale
    std::size_t averaged = 0;            // pairs of a square whose two ratings differed
    std::vector<std::string> remarks{};  // sentences without a full stop
};

Expected<RatingsText> ratings_text(std::string_view text, const std::string& file,
                                   const AnswerColumns& columns = {});

// Its form with a line a rating; the first record names the columns. `text_bytes` of the whole.
Expected<RatingsText> ratings_of_lines(const std::string& file,
                                       const std::vector<CsvRecord>& records,
                                       std::size_t text_bytes);

// Its form with a line a sorted pattern, as model/io/people/study_csv.h writes it.
Expected<RatingsText> ratings_of_sortings(const std::string& file,
                                          const std::vector<CsvRecord>& records,
                                          std::size_t text_bytes);

// The place of each column that the head has; of two of one name that of the last.
struct NamedColumn {
    const char* name;
    std::optional<std::size_t>* place;
};
void find_columns(const CsvRecord& head, std::initializer_list<NamedColumn> wanted);

// The columns that say who counts, of a file with a line an answer; none is needed.
struct MarkColumns {
    std::optional<std::size_t> excluded, synthetic, rehearsal, whole, why, fingerprint;
};
MarkColumns mark_columns(const CsvRecord& head);

// What is wrong with the head where a column that says who answered, or who counts, is misspelt, or
// empty: left aside, it would count a simulation as a person, or all people as one.
std::string column_fault(const CsvRecord& head);

// What they say of one answer.
struct Marks {
    bool excluded = false;
    bool synthetic = false;
    bool rehearsal = false;
    bool whole = true;
    std::string why;
    std::string fingerprint;
};
Expected<Marks> marks_in(const MarkColumns& columns, const std::vector<std::string>& fields);

// What the marks of all answers of one participant come to.
struct MarkedAnswers {
    std::size_t counted = 0;
    std::size_t excluded = 0;
    std::size_t unfelt = 0;  // in a rehearsal, or not whole
    std::size_t rehearsed = 0;
    bool synthetic = false;
    std::string why;  // of the first that is excluded
};
void note_marks(MarkedAnswers& answers, const Marks& marks);

// How the participant stands, if anything is to be said of it; an answer among others that is left
// out is a remark.
void note_standing(RatingsText& into, const std::string& participant, const MarkedAnswers& answers);

// A rating, NaN if the cell says that it is missing, nothing if it is neither.
std::optional<double> rating_in(const std::string& field);

// What to say where there is neither.
std::string expected_rating(const std::string& field);

}  // namespace tact
