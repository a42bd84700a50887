// The pairs of a set in square tiles, so that a large matrix can be computed piece by piece: by
// many threads, by several machines, today and after a stop.
//
//            j
//        0\  1  2 |      Tile k of the upper triangle, row by row: the pairs (i, j), i < j, with i
//     i      3\ 4 |      and j in two ranges of patterns. Its values depend on the codes of these
//               5\|      two ranges and on nothing else.
//
// Input     codes as pattern_codes gives them, without their waveforms
// Output    values of a tile row by row, those with i >= j left out
// Left out  ranks, and so PM: they need all pairs.
// Exact     same bits as nc_matrix and oc_matrix, in whatever order and wherever tiles are made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/physiology/nc_matrix.h"

namespace tact {

enum class Part { nc, oc };

struct Tile {
    std::size_t row = 0, row_end = 0;        // of i
    std::size_t column = 0, column_end = 0;  // of j

    bool operator==(const Tile&) const = default;
};

// Patterns on a side: few enough that a stop loses little, enough to fill lanes and caches. The
// size of the set alone decides, so that a stopped run can continue with more threads.
std::size_t tile_side(std::size_t patterns);

std::size_t tile_count(std::size_t patterns);
Tile tile_at(std::size_t patterns, std::size_t index);
std::size_t pair_count(const Tile& tile);

// What tiles are made from: half of what a code takes, as waveforms are left out.
struct TileSource {
    PerReceptor<double> channel_weight{};
    double waiting_cost = 0.0;
    std::size_t samples = 0;                     // that were coded of every pattern
    std::vector<PackedSpikes> spikes;            // of every pattern
    std::vector<std::vector<double>> envelopes;  // likewise, without the zeros at their ends
    // Fingerprints of what they were made from, to tell why they are others; 0: not known.
    std::uint64_t vibrations = 0;
    std::uint64_t model = 0;
};

void add_pattern(TileSource& source, const PatternCode& code);
std::size_t pattern_count(const TileSource& source);

// What each tile costs, in cells of dynamic time warping (OC) or pairs (NC): pairs of envelopes
// cost the product of their own lengths, where both end in silence.
std::vector<double> tile_costs(const TileSource& source, Part part);

// The tiles, the costliest first: what is left at the end is short, and none keeps the others
// waiting. Tiles that cost the same stand as they are numbered.
std::vector<std::size_t> by_cost(std::span<const double> tile_costs);

// A number that changes with anything a tile's value depends on; the same from what a source is
// made from.
std::uint64_t fingerprint(const TileSource& source);
std::uint64_t fingerprint(std::span<const std::shared_ptr<const PatternCode>> codes,
                          const PerceptualModelParams& params);

// With a stop asked for, values are wrong, and it returns soon.
std::vector<double> tile_values(const TileSource& source, Part part, const Tile& tile,
                                std::stop_token stop = {});

// Writes a tile's values to where they belong.
void put_tile(Dissimilarity& matrix, const Tile& tile, std::span<const double> values);

// They come back as tile_values gave them.
std::vector<double> tile_of(const Dissimilarity& matrix, const Tile& tile);

// Where threads take tiles from and bring values to. Both are called from any thread.
struct TileDesk {
    // A tile's index for a thread (0, 1, ..); none: no more.
    std::function<std::optional<std::size_t>(std::size_t thread)> next;
    std::function<void(std::size_t index, std::span<const double> values)> done;
};

// Takes tiles from the desk until there are no more. threads = 0: all cores. With a stop asked for,
// tiles that are under way are dropped, as one of long patterns may take minutes; the desk is asked
// on, so that it knows that none is left.
void make_tiles(const TileSource& source, Part part, int threads, const TileDesk& desk,
                std::stop_token stop = {});

}  // namespace tact
