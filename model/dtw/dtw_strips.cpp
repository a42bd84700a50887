#include "model/dtw/dtw_strips.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace tact {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Of one pair: with D of the row above 128 KiB, a part of any second-level cache.
constexpr std::size_t kCachedColumns = 8192;

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

void dtw_strips(const DtwSweep& sweep, std::span<const SignalPair> pairs, double waiting_cost,
                std::span<double> distances, const std::stop_token& stop) {
    assert(!pairs.empty() && pairs.size() <= sweep.pairs && pairs.size() == distances.size());
    std::size_t rows = 0;
    std::size_t columns = 0;
    for (const SignalPair& pair : pairs) {
        rows = std::max(rows, pair.a.size());
        columns = std::max(columns, pair.b.size());
    }
    std::ranges::fill(distances, kNowhere);
    if (rows == 0 && columns == 0) std::ranges::fill(distances, 0.0);
    if (rows == 0 || columns == 0) return;

    // The last row of a strip is `margin` columns behind the first. Before column 0 all of D comes
    // out as infinity, as everything it could come from is; and no cell needs what comes after the
    // last column, nor the rows that fill up the last strip: zeros will do.
    const std::size_t side = sweep.pairs;
    const std::size_t margin = sweep.rows - 1;
    const std::size_t strips = (rows + margin) / sweep.rows;
    Lines a(strips * sweep.rows * side, 0.0);
    Lines b((columns + 2 * margin) * side, 0.0);
    Lines row((columns + 2 * margin) * side, kNowhere);
    const std::size_t state = sweep.rows * side;  // of one strip
    Lines reached(strips * state, kNowhere);
    Lines above_left(strips * state, kNowhere);
    double* const b_first = b.data() + (margin + columns - 1) * side;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const std::size_t its_columns = pairs[p].b.size();
        for (std::size_t i = 0; i < pairs[p].a.size(); ++i) a.data()[i * side + p] = pairs[p].a[i];
        for (std::size_t j = 0; j < its_columns; ++j) *(b_first + p - j * side) = pairs[p].b[j];
    }
    // The path starts at no cost before the first cell.
    std::fill_n(above_left.data(), side, 0.0);

    const auto along = waiting_cost > 0.0 ? sweep.along_at_cost : sweep.along;
    // As many columns as stay in the cache, with all strips, before the next ones. A strip may go
    // as far as the one above it has finished its last row: `margin` columns less.
    const std::size_t block = kCachedColumns / side;
    std::vector<std::size_t> done(strips, 0);
    const std::size_t last_steps = columns + (rows - 1) % sweep.rows;
    for (std::size_t end = block; done.back() < last_steps; end += block) {
        for (std::size_t s = 0; s < strips; ++s) {
            if (stop.stop_requested()) return;
            const std::size_t used = std::min(sweep.rows, rows - s * sweep.rows);
            // Leaves the last row used at the last column.
            const std::size_t whole = columns + used - 1;
            const std::size_t until = std::min(whole, end - std::min(end, s * margin));
            if (until <= done[s]) continue;
            along({.a = a.data() + s * state,
                   .b = b_first - done[s] * side,
                   .row = row.data() + (margin + done[s]) * side,
                   .steps = until - done[s],
                   .reached = reached.data() + s * state,
                   .above_left = above_left.data() + s * state,
                   .waiting_cost = waiting_cost});
            done[s] = until;
        }
    }
    const double* const last = reached.data() + (strips - 1) * state;
    const std::size_t last_row = (rows - 1) % sweep.rows;
    for (std::size_t p = 0; p < pairs.size(); ++p) distances[p] = last[last_row * side + p];
}

}  // namespace tact
