// A dissimilarity matrix as a heat map: similar pairs and distant ones.
//
// Input     condensed values of n objects; NaN: unknown
// Output    the pair under the mouse and the clicked pair
// If all pairs are equal and not zero, a text says so, and all have one quiet tone.
// Valid     any n; at most kMostCells x kMostCells cells are drawn. With more objects, a cell shows
//           the mean of at most 3 x 3 of its pairs, evenly spread: the cost is bounded. The
//           read-out says so, and gives the pair under the mouse.
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
    std::span<const std::string> labels{};    // n names, one of each row
    std::span<const std::size_t> order{};     // the object of each row; empty: the given order
    double largest = 0.0;                     // value with the darkest colour; 0: the largest of
                                              // all
    std::string_view quantity{};              // name of the values, for scale and read-out: "PM"
    std::span<const std::size_t> selected{};  // emphasised rows and columns, ascending
    std::optional<Pair> pointed{};            // a pair under the mouse elsewhere
    bool stale = false;
};

struct MatrixAction {
    std::optional<Pair> hovered{};  // row, column; never on the diagonal
    std::optional<Pair> clicked{};
    std::optional<std::size_t> clicked_row{};  // its label or its diagonal cell
};

MatrixAction draw_matrix(const char* id, const Theme& theme, const Rect& area,
                         const MatrixScene& scene);

// Places of the parts: the cells, names left of and above them, the scale at the right. Cells are
// as large as the pane allows. Many cells are square; few are wider than high if numbers then fit
// in them, and the scale moves below if a line is free there. Pure, for tests.
struct MatrixLayout {
    Rect cells;
    Rect scale;                  // empty if there is no room
    Rect scale_below;            // the scale as one line, if there is only room for that
    ImVec2 cell_px{0.0F, 0.0F};  // of one pair, if each has its own cell
    bool has_values = false;     // numbers in the cells; with many cells, in the selected rows
    std::size_t shown = 0;       // drawn rows: n, or fewer if several objects share one
    std::size_t label_step = 1;  // every k-th object is named; 0: none
    bool column_labels = false;
    bool level_labels = false;  // above wide cells, cut if the rows have the whole names
};

MatrixLayout matrix_layout(const Theme& theme, const Rect& area, const MatrixScene& scene);

// The object whose row, or column, is this number of pixels from the first.
std::optional<std::size_t> row_at(const MatrixLayout& layout, std::size_t n, float offset_px);
std::optional<std::size_t> column_at(const MatrixLayout& layout, std::size_t n, float offset_px);

}  // namespace tact
