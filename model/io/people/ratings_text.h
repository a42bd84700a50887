// One text of ratings in any of the forms that ratings_file.h names, before it is known which way
// its numbers run.
//
// Output    errors as "FILE:LINE: expected .."
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/study/ratings.h"
#include "model/text/csv.h"

namespace tact {

inline constexpr std::size_t kMaxRatedPatterns = 500;  // nobody rates more: 124,750 pairs
inline constexpr std::size_t kMaxJudgements = 1000;

struct RatingsText {
    std::string file;
    RatingStudy study;              // participants as the text names them, or ""
    std::vector<double> identical;  // ratings of a pattern with itself
    bool is_similarity = false;     // as a study of this program says it: no guess is needed
    std::size_t averaged = 0;       // pairs of a square whose two ratings differed
};

Expected<RatingsText> ratings_text(std::string_view text, const std::string& file);

// Its form with a line a rating; the first record names the columns.
Expected<RatingsText> ratings_of_lines(const std::string& file,
                                       const std::vector<CsvRecord>& records);

// A rating, NaN where the cell says that there is none, nothing where it is neither.
std::optional<double> rating_in(const std::string& field);

// What to say where there is neither.
std::string expected_rating(const std::string& field);

// Without the blanks around it.
std::string trimmed(const std::string& text);

}  // namespace tact
