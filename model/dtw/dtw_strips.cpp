#include "model/dtw/dtw_strips.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cassert>
#include <limits>
#include <system_error>
#include <thread>
#include <vector>

namespace tact {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Columns of one pair: with D of the row above 128 KiB, a part of any second-level cache.
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

// The matrices of some pairs side by side: signals and state, strip by strip.
//
// The last row of a strip is `margin` columns behind the first. Before column 0 all of D comes out
// as infinity, as everything it could come from is; and no cell needs what comes after the last
// column, nor the rows that fill up the last strip: zeros will do.
class Matrices {
  public:
    Matrices(const DtwSweep& sweep, std::span<const SignalPair> pairs, std::size_t rows,
             std::size_t columns, double waiting_cost)
        : sweep_(sweep),
          rows_(rows),
          columns_(columns),
          waiting_cost_(waiting_cost),
          margin_(sweep.rows - 1),
          strips_((rows + margin_) / sweep.rows),
          block_(kCachedColumns / sweep.pairs),
          a_(strips_ * sweep.rows * sweep.pairs, 0.0),
          b_((columns + 2 * margin_) * sweep.pairs, 0.0),
          row_((columns + 2 * margin_) * sweep.pairs, kNowhere),
          reached_(strips_ * state(), kNowhere),
          above_left_(strips_ * state(), kNowhere),
          b_first_(b_.data() + (margin_ + columns - 1) * sweep.pairs),
          done_(strips_, 0) {
        const std::size_t side = sweep.pairs;
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            const auto a = pairs[p].a;
            const auto b = pairs[p].b;
            for (std::size_t i = 0; i < a.size(); ++i) a_.data()[i * side + p] = a[i];
            for (std::size_t j = 0; j < b.size(); ++j) *(b_first_ + p - j * side) = b[j];
        }
        // The path starts at no cost before the first cell.
        std::fill_n(above_left_.data(), side, 0.0);
    }

    std::size_t strips() const { return strips_; }

    // As many columns as stay in the cache, with all strips, before the next ones.
    std::size_t blocks() const {
        const std::size_t last = columns_ + (rows_ - 1) % sweep_.rows + (strips_ - 1) * margin_;
        return (last + block_ - 1) / block_;
    }

    // Takes a strip along a block of columns: after it has gone along the block before, and the
    // strip above along the same one. A strip may go as far as the one above it has finished its
    // last row: `margin` columns less. So what strips read and write in their blocks does not
    // overlap where both are as far down as along together.
    void advance(std::size_t strip, std::size_t block) {
        const std::size_t used = std::min(sweep_.rows, rows_ - strip * sweep_.rows);
        const std::size_t whole = columns_ + used - 1;  // leaves the last row used at the end
        const std::size_t end = (block + 1) * block_;
        const std::size_t until = std::min(whole, end - std::min(end, strip * margin_));
        std::size_t& done = done_[strip];
        if (until <= done) return;
        const auto along = waiting_cost_ > 0.0 ? sweep_.along_at_cost : sweep_.along;
        along({.a = a_.data() + strip * state(),
               .b = b_first_ - done * sweep_.pairs,
               .row = row_.data() + (margin_ + done) * sweep_.pairs,
               .steps = until - done,
               .reached = reached_.data() + strip * state(),
               .above_left = above_left_.data() + strip * state(),
               .waiting_cost = waiting_cost_});
        done = until;
    }

    double distance(std::size_t pair) {
        const std::size_t last_row = (rows_ - 1) % sweep_.rows;
        return reached_.data()[(strips_ - 1) * state() + last_row * sweep_.pairs + pair];
    }

  private:
    std::size_t state() const { return sweep_.rows * sweep_.pairs; }  // of one strip

    const DtwSweep& sweep_;
    std::size_t rows_;
    std::size_t columns_;
    double waiting_cost_;
    std::size_t margin_;
    std::size_t strips_;
    std::size_t block_;
    Lines a_;
    Lines b_;
    Lines row_;
    Lines reached_;
    Lines above_left_;
    double* b_first_;
    std::vector<std::size_t> done_;  // steps of each strip
};

// False: stopped.
bool advance_all(Matrices& matrices, const std::stop_token& stop) {
    for (std::size_t block = 0; block < matrices.blocks(); ++block) {
        for (std::size_t strip = 0; strip < matrices.strips(); ++strip) {
            if (stop.stop_requested()) return false;
            matrices.advance(strip, block);
        }
    }
    return true;
}

// Strips and blocks of one diagonal need nothing of each other.
bool advance_all(Matrices& matrices, int threads, const std::stop_token& stop) {
    const std::size_t strips = matrices.strips();
    const std::size_t blocks = matrices.blocks();
    const auto first_of = [&](std::size_t d) { return d + 1 - std::min(d + 1, blocks); };
    std::size_t diagonal = 0;
    std::atomic<std::size_t> next{0};
    bool stopped = false;
    std::barrier together(threads, [&]() noexcept {
        ++diagonal;
        next = first_of(diagonal);
        stopped = stop.stop_requested();
    });
    const auto work = [&] {
        while (!stopped && diagonal < strips + blocks - 1) {
            const std::size_t end = std::min(diagonal + 1, strips);
            for (std::size_t strip = next++; strip < end; strip = next++) {
                matrices.advance(strip, diagonal - strip);
            }
            together.arrive_and_wait();
        }
    };
    std::vector<std::jthread> others;
    int missing = threads - 1;
    try {
        for (; missing > 0; --missing) others.emplace_back(work);
    } catch (const std::system_error&) {
        // The threads that are there do the work.
    }
    for (; missing > 0; --missing) together.arrive_and_drop();
    work();
    return !stopped;
}

}  // namespace

void dtw_strips(const DtwSweep& sweep, std::span<const SignalPair> pairs, double waiting_cost,
                std::span<double> distances, const std::stop_token& stop, int threads) {
    assert(!pairs.empty() && pairs.size() <= sweep.pairs && pairs.size() == distances.size());
    std::size_t rows = 0;
    std::size_t columns = 0;
    for (const SignalPair& pair : pairs) {
        rows = std::max(rows, pair.rows());
        columns = std::max(columns, pair.columns());
    }
    std::ranges::fill(distances, kNowhere);
    if (rows == 0 && columns == 0) std::ranges::fill(distances, 0.0);
    if (rows == 0 || columns == 0) return;
    Matrices matrices(sweep, pairs, rows, columns, waiting_cost);
    const bool is_done =
        threads > 1 ? advance_all(matrices, threads, stop) : advance_all(matrices, stop);
    if (!is_done) return;
    for (std::size_t p = 0; p < pairs.size(); ++p) distances[p] = matrices.distance(p);
}

}  // namespace tact
