#include "model/dtw_strips.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace tact {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Doubles from the start of a cache line on: a register that lies across two takes two loads.
class Lines {
  public:
    Lines(std::size_t count, double value) : lines_((count + kPerLine - 1) / kPerLine) {
        for (Line& line : lines_) std::ranges::fill(line.values, value);
    }
    double* data() { return lines_.front().values; }

  private:
    static constexpr std::size_t kPerLine = 8;
    struct alignas(64) Line {
        double values[kPerLine];
    };
    std::vector<Line> lines_;
};

}  // namespace

void dtw_strips(const DtwSweep& sweep, std::span<const SignalPair> pairs,
                std::span<double> distances, const std::stop_token& stop) {
    assert(!pairs.empty() && pairs.size() <= sweep.pairs && pairs.size() == distances.size());
    const std::size_t rows = pairs[0].a.size();
    const std::size_t columns = pairs[0].b.size();
    std::ranges::fill(distances, kNowhere);
    if (rows == 0 && columns == 0) std::ranges::fill(distances, 0.0);
    if (rows == 0 || columns == 0) return;

    // The last row of a strip is `margin` columns behind the first. Before column 0 all of D comes
    // out as infinity, as everything it could come from is; and no cell needs what comes after the
    // last column, nor the rows that fill up the last strip: zeros will do.
    const std::size_t side = sweep.pairs;
    const std::size_t margin = sweep.rows - 1;
    Lines a((rows + margin) * side, 0.0);
    Lines b((columns + 2 * margin) * side, 0.0);
    Lines row((columns + 2 * margin) * side, kNowhere);
    Lines last(sweep.rows * side, kNowhere);
    double* const b_first = b.data() + (margin + columns - 1) * side;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        assert(pairs[p].a.size() == rows && pairs[p].b.size() == columns);
        for (std::size_t i = 0; i < rows; ++i) a.data()[i * side + p] = pairs[p].a[i];
        for (std::size_t j = 0; j < columns; ++j) *(b_first + p - j * side) = pairs[p].b[j];
    }
    double corner = 0.0;  // the path starts at no cost before the first cell
    for (std::size_t first = 0; first < rows; first += sweep.rows) {
        if (stop.stop_requested()) return;
        const std::size_t used = std::min(sweep.rows, rows - first);
        sweep.along({.a = a.data() + first * side,
                     .b = b_first,
                     .row = row.data() + margin * side,
                     .corner = corner,
                     .steps = columns + used - 1,  // leaves the last row used at the last column
                     .last = last.data()});
        corner = kNowhere;
    }
    const std::size_t last_row = (rows - 1) % sweep.rows;
    for (std::size_t p = 0; p < pairs.size(); ++p) distances[p] = last.data()[last_row * side + p];
}

}  // namespace tact
