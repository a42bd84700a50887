// Coordinates as `tactspace space` writes them: a row a name, its place after it.
//
//     name,D1,D2,D3
//     low,0.1,-0.2,0.3
//
// In the place of "name" may stand what is false about all of them, which is handed on.
// Input     any way in which a table is written (model/table/table.h); without the word above the
//           names, as R's write.table does
// Output    errors as "FILE:LINE: expected .."
// Valid     finite numbers, kMaxCoordinatesBytes: a row of four bytes takes a hundred
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/number_mark.h"
#include "model/table/table.h"

namespace tact {

inline constexpr std::size_t kMaxCoordinatesBytes = std::size_t{1} << 25;

struct LabelledPoints {
    std::vector<std::string> labels;
    Eigen::MatrixXd points;              // one row a label
    NumberMark mark{};                   // of the corner, where it is no heading
    std::vector<std::string> remarks{};  // how the table was understood, where it could be misread
};

Expected<LabelledPoints> parse_coordinates(std::string_view bytes, const std::string& file,
                                           const TableHints& hints = {});
Expected<LabelledPoints> read_coordinates_file(const std::filesystem::path& path,
                                               const TableHints& hints = {});

}  // namespace tact
