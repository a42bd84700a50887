// Dissimilarity matrices and coordinates as tables.
//
//     ,name1,name2        name,D1,D2,D3
//     name1,0,3.5         name1,0.1,-0.2,0.3
//     name2,3.5,0
//
// Source    quoting as in RFC 4180; numbers in the shortest digits that read back as the same
// Input     any way in which a table is written (model/table/table.h); bare numbers, whose names
//           are 1, 2, 3 ..; names in the first row alone; rows in another order; one triangle, also
//           as R prints distances; nothing, NA or 0 on the diagonal; similarities, which have one
//           number there that no other exceeds
// Output    errors as "FILE:LINE: expected .."
// Valid     at most 10,000 objects, in a file of at most kMaxFileBytes (and 0.4 GB of numbers);
//           symmetric to 1e-9 of the larger value, or to the digits written, four decimals at
//           least
// Left out  rectangular matrices; unknown pairs
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dissimilarity/number_mark.h"
#include "model/table/table.h"

namespace tact {

struct LabelledMatrix {
    std::vector<std::string> labels;
    Dissimilarity dissimilarity;  // of values that differ by rounding, the ones above the diagonal
    NumberMark mark{};            // of the corner
    std::vector<std::string> remarks{};  // how the table was understood, where it could be misread
};

// A text as a field of a CSV line: in quotes where it has to be, and guarded from spreadsheets.
std::string csv_field(std::string_view text);

// Such fields with commas between them, and the end of the line.
std::string csv_row(std::span<const std::string> texts);

// Row by row, so that a matrix of 10,000 needs no gigabyte of memory. As many labels as objects.
// The corner says what is to be said of the numbers (model/dissimilarity/number_mark.h).
void write_matrix_csv(std::ostream& stream, std::span<const std::string> labels,
                      const Dissimilarity& dissimilarity, const std::string& corner = {});
Expected<Done> write_matrix_file(const std::filesystem::path& path,
                                 std::span<const std::string> labels,
                                 const Dissimilarity& dissimilarity);

// One row a label, k columns. A corner stands in the place of "name".
void write_coordinates_csv(std::ostream& stream, std::span<const std::string> labels,
                           const Eigen::MatrixXd& points, const std::string& corner = {});

Expected<LabelledMatrix> parse_matrix(std::string_view text, const std::string& file,
                                      const TableHints& hints = {});
Expected<LabelledMatrix> read_matrix_file(const std::filesystem::path& path,
                                          const TableHints& hints = {});

// How far apart the objects of these names are by a matrix that may have others and another order.
// An Error names the file and the first that is missing.
Expected<Dissimilarity> dissimilarities_of(const LabelledMatrix& matrix,
                                           std::span<const std::string> names,
                                           const std::string& file);

}  // namespace tact
