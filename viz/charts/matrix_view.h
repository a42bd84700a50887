// A dissimilarity matrix as a heat map: which pairs are alike (dark) and which far apart (bright).
//
// Input     condensed values of n objects; NaN: unknown
// Output    the pair under the mouse and the pair clicked
//           Where all pairs are equal, and not zero, they say so and none is bright.
// Valid     any n; at most kMostCells x kMostCells cells are drawn. Where that is fewer than n a
//           cell shows the mean of at most 3 x 3 of its pairs, evenly spread: cost is bounded.
// Left out  reordering, dendrograms.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

inline constexpr std::size_t kMostCells = 200;  // along one side

using Pair = std::pair<std::size_t, std::size_t>;

struct MatrixScene {
    std::span<const double> condensed{};      // n (n - 1) / 2 values
    std::span<const std::string> labels{};    // n names
    double largest = 0.0;                     // the darkest value; 0: the largest there is
    std::string_view quantity{};              // what the values are, for scale and read-out: "PM"
    std::span<const std::size_t> selected{};  // rows and columns to stand out, ascending
    std::optional<Pair> pointed{};            // a pair pointed at elsewhere
    bool stale = false;
};

struct MatrixAction {
    std::optional<Pair> hovered{};  // row, column; never on the diagonal
    std::optional<Pair> clicked{};
    std::optional<std::size_t> clicked_row{};  // its label or its diagonal cell
};

MatrixAction draw_matrix(const char* id, const Theme& theme, const Rect& area,
                         const MatrixScene& scene);

// Where the parts go: the cells, room for names left of and above them, the scale to the right.
// Cells are as large as the pane has room for, square where there are many, and of a few wider than
// high where numbers then fit in them; for numbers the scale goes below, where a line is free.
// Pure, for tests.
struct MatrixLayout {
    Rect cells;
    Rect scale;                  // empty where there is no room
    Rect scale_below;            // a line of the scale, where there is room for that alone
    ImVec2 cell_px{0.0F, 0.0F};  // of one pair, where each has its own cell
    bool has_values = false;     // as numbers in the cells; of many, in the selected rows
    std::size_t shown = 0;       // rows drawn: n, or fewer where several objects share one
    std::size_t label_step = 1;  // every how many-th object is named; 0: none
    bool column_labels = false;
    bool level_labels = false;  // above wide cells, cut where rows have them whole
};

MatrixLayout matrix_layout(const Theme& theme, const Rect& area, const MatrixScene& scene);

// The object whose row, or column, is at an offset of pixels from the first.
std::optional<std::size_t> row_at(const MatrixLayout& layout, std::size_t n, float offset_px);
std::optional<std::size_t> column_at(const MatrixLayout& layout, std::size_t n, float offset_px);

}  // namespace tact
