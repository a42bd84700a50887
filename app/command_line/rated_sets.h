// Sets of a command with what people said of them.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/command_line/commands.h"
#include "app/rendering/rendering.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/io/people/foreign_answers.h"
#include "model/io/tables/coordinates_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/set/pattern_set.h"
#include "model/study/who_counts.h"

namespace tact {

// One set with its ratings, in the order of its patterns.
struct RatedPatterns {
    PatternSet set;
    std::string name;
    RatingStudy study;
    std::vector<LeftOutParticipant> left_out;
    Labels labels;
};

// The participants that the numbers leave out, a line each.
std::string text_on(const std::vector<LeftOutParticipant>& left_out);

// [{"participant": .., "why": ..}, ..]
nlohmann::json json_of(const std::vector<LeftOutParticipant>& left_out);

// Exclusions with a reason into the folders of studies that these are, or are in, and inclusions
// out of them; what changed, or could not, is said on standard error.
Expected<Done> record_who_counts(std::span<const std::filesystem::path> files,
                                 const CountRule& who);

// Each set of a command with its files of ratings: all of them for a single set, otherwise one for
// each; without files, those of the set file. Remarks go to standard error.
Expected<std::vector<RatedPatterns>> load_rated(const CommonOptions& common,
                                                const RatingFiles& ratings);

// What somebody says of tables of ratings by --columns, --separator and --decimal.
Expected<AnswerColumns> told_columns(const std::string& columns, const TableHints& written);

// What could not be read of ratings, with the option that names their columns where that helps.
Error with_columns_option(Error error);

// Files of coordinates, and of a matrix; how each was understood is told on standard error.
Expected<LabelledPoints> told_points(const std::filesystem::path& file, const TableHints& written);
Expected<LabelledMatrix> told_matrix(const std::filesystem::path& file, const TableHints& written);

// How far apart the patterns of these names are by a matrix that may have others and another order.
// `mark`: of what the file says of its numbers.
Expected<Dissimilarity> dissimilarities_in(const std::filesystem::path& file,
                                           const std::vector<std::string>& names,
                                           const TableHints& written, NumberMark* mark = nullptr);

}  // namespace tact
