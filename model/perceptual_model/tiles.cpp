#include "model/perceptual_model/tiles.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <utility>

#include "model/common/fingerprint.h"
#include "model/common/parallel.h"
#include "model/dtw/dtw.h"

namespace tact {

namespace {

// 64 tiles across make 2,080 of them: a tile that every one of 20 threads loses is 1 %.
constexpr std::size_t kAcross = 64;
constexpr std::size_t kSmallestSide = 4;
constexpr std::size_t kLargestSide = 32;

std::size_t tiles_across(std::size_t patterns) {
    const std::size_t side = tile_side(patterns);
    return (patterns + side - 1) / side;
}

template <class Visit>
void for_each_pair(const Tile& tile, Visit&& visit) {
    for (std::size_t i = tile.row; i < tile.row_end; ++i) {
        for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j) visit(i, j);
    }
}

std::vector<double> nc_values(const TileSource& source, const Tile& tile, std::stop_token stop) {
    std::vector<double> values;
    values.reserve(pair_count(tile));
    for_each_pair(tile, [&](std::size_t i, std::size_t j) {
        if (stop.stop_requested()) return values.push_back(0.0);
        const PackedSpikes& a = source.spikes[i];
        const PackedSpikes& b = source.spikes[j];
        values.push_back(nc_dissimilarity(spike_form(a, b), a.samples, source.channel_weight));
    });
    return values;
}

std::vector<double> oc_values(const TileSource& source, const Tile& tile, std::stop_token stop) {
    std::vector<SignalPair> pairs;
    pairs.reserve(pair_count(tile));
    for_each_pair(tile, [&](std::size_t i, std::size_t j) {
        pairs.push_back({source.envelopes[i], source.envelopes[j], source.samples, source.samples});
    });
    DtwOptions options;
    options.threads = 1;  // the others are at other tiles
    options.waiting_cost = source.waiting_cost;
    options.stop = std::move(stop);
    return dtw(pairs, options);
}

std::uint64_t mixed_params(const PerReceptor<double>& channel_weight, double waiting_cost) {
    const std::uint64_t number = mixed(0, std::span<const double>(channel_weight));
    return waiting_cost > 0.0 ? mixed(number, std::span<const double>(&waiting_cost, 1)) : number;
}

std::uint64_t mixed_pattern(std::uint64_t number, std::size_t samples, const PackedSpikes& spikes,
                            const std::vector<double>& envelope) {
    number = mixed(number, samples);
    number = mixed(number, std::span<const std::uint64_t>(spikes.bits));
    return mixed(number, std::span<const double>(envelope));
}

}  // namespace

std::size_t tile_side(std::size_t patterns) {
    std::size_t side = kSmallestSide;
    while (side < kLargestSide && side * kAcross < patterns) side *= 2;
    return side;
}

std::size_t tile_count(std::size_t patterns) {
    // A triangle with its diagonal is one without, of one more.
    return pair_count(tiles_across(patterns) + 1);
}

Tile tile_at(std::size_t patterns, std::size_t index) {
    assert(index < tile_count(patterns) && "tile outside the matrix");
    const auto [row, column_plus_one] = pair_at(tiles_across(patterns) + 1, index);
    const std::size_t side = tile_side(patterns);
    const auto end = [&](std::size_t begin) { return std::min(begin + side, patterns); };
    Tile tile{.row = row * side, .column = (column_plus_one - 1) * side};
    tile.row_end = end(tile.row);
    tile.column_end = end(tile.column);
    return tile;
}

std::size_t pair_count(const Tile& tile) {
    const std::size_t rows = tile.row_end - tile.row;
    return tile.row == tile.column ? pair_count(rows) : rows * (tile.column_end - tile.column);
}

void add_pattern(TileSource& source, const PatternCode& code) {
    source.spikes.push_back(packed_spikes(code.neural));
    source.envelopes.push_back(code.envelope);
    source.samples = code.samples;
}

std::size_t pattern_count(const TileSource& source) { return source.envelopes.size(); }

std::vector<double> tile_costs(const TileSource& source, Part part) {
    const std::size_t patterns = pattern_count(source);
    std::vector<double> whole(patterns);
    std::vector<double> own(patterns);
    std::vector<bool> ends_silent(patterns);
    for (std::size_t k = 0; k < patterns; ++k) {
        const std::size_t length = source.envelopes[k].size();
        whole[k] = static_cast<double>(source.samples);
        own[k] = static_cast<double>(std::min(length + 1, source.samples));  // up to a last zero
        ends_silent[k] = source.waiting_cost == 0.0 && length < source.samples;
    }
    std::vector<double> costs(tile_count(patterns), 0.0);
    for (std::size_t tile = 0; tile < costs.size(); ++tile) {
        for_each_pair(tile_at(patterns, tile), [&](std::size_t i, std::size_t j) {
            const bool trimmed = ends_silent[i] && ends_silent[j];
            const double cells = trimmed ? own[i] * own[j] : whole[i] * whole[j];
            costs[tile] += part == Part::nc ? 1.0 : cells;
        });
    }
    return costs;
}

std::vector<std::size_t> by_cost(std::span<const double> tile_costs) {
    std::vector<std::size_t> order(tile_costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return tile_costs[k]; });
    return order;
}

std::uint64_t fingerprint(const TileSource& source) {
    std::uint64_t number = mixed_params(source.channel_weight, source.waiting_cost);
    for (std::size_t k = 0; k < pattern_count(source); ++k) {
        number = mixed_pattern(number, source.samples, source.spikes[k], source.envelopes[k]);
    }
    return number;
}

std::uint64_t fingerprint(std::span<const std::shared_ptr<const PatternCode>> codes,
                          const PerceptualModelParams& params) {
    std::uint64_t number = mixed_params(params.channel_weight, params.envelope.waiting_cost);
    for (const auto& code : codes) {
        number = mixed_pattern(number, code->samples, packed_spikes(code->neural), code->envelope);
    }
    return number;
}

std::vector<double> tile_values(const TileSource& source, Part part, const Tile& tile,
                                std::stop_token stop) {
    return part == Part::nc ? nc_values(source, tile, std::move(stop))
                            : oc_values(source, tile, std::move(stop));
}

void put_tile(Dissimilarity& matrix, const Tile& tile, std::span<const double> values) {
    assert(values.size() == pair_count(tile) && "values of another tile");
    std::size_t next = 0;
    for_each_pair(tile, [&](std::size_t i, std::size_t j) {
        matrix.condensed[pair_index(matrix.size, i, j)] = values[next++];
    });
}

std::vector<double> tile_of(const Dissimilarity& matrix, const Tile& tile) {
    std::vector<double> values;
    values.reserve(pair_count(tile));
    for_each_pair(tile, [&](std::size_t i, std::size_t j) { values.push_back(matrix(i, j)); });
    return values;
}

void make_tiles(const TileSource& source, Part part, int threads, const TileDesk& desk,
                std::stop_token stop) {
    const auto workers = static_cast<std::size_t>(thread_count(threads));
    parallel_for(workers, static_cast<int>(workers), {}, [&](std::size_t thread) {
        while (const auto index = desk.next(thread)) {
            const Tile tile = tile_at(pattern_count(source), *index);
            const std::vector<double> values = tile_values(source, part, tile, stop);
            if (!stop.stop_requested()) desk.done(*index, values);
        }
    });
}

}  // namespace tact
