#include "model/perceptual_model/refinement.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/dtw/dtw.h"
#include "model/perceptual_model/tiles.h"

namespace tact {

namespace {

template <class Visit>
void for_each_open_pair(const Refinement& refinement, std::size_t tile, Visit&& visit) {
    const std::size_t patterns = refinement.codes.size();
    const Tile area = tile_at(patterns, tile);
    for (std::size_t i = area.row; i < area.row_end; ++i) {
        for (std::size_t j = std::max(area.column, i + 1); j < area.column_end; ++j) {
            const std::size_t pair = pair_index(patterns, i, j);
            if (refinement.is_exact[pair] == 0) visit(i, j, pair);
        }
    }
}

void measure_lengths(Refinement& refinement) {
    const bool waiting_costs = refinement.params.envelope.waiting_cost > 0.0;
    for (const auto& code : refinement.codes) {
        const std::vector<double>& envelope = code->envelope;
        const auto last =
            std::find_if(envelope.rbegin(), envelope.rend(), [](double v) { return v != 0.0; });
        const auto own = static_cast<std::size_t>(envelope.rend() - last);
        const bool is_silent = own < code->samples && !waiting_costs;
        refinement.is_silent.push_back(is_silent ? 1 : 0);
        refinement.own_length.push_back(static_cast<double>(is_silent ? own + 1 : code->samples));
    }
}

// Which tiles have nothing open.
void find_made(Refinement& refinement) {
    for (std::size_t tile = 0; tile < refinement.is_made.size(); ++tile) {
        bool is_made = true;
        for_each_open_pair(refinement, tile, [&](auto, auto, auto) { is_made = false; });
        refinement.is_made[tile] = is_made ? 1 : 0;
    }
}

// What makes coarse values as large, in all, as the exact ones of the same pairs.
double coarse_scale(const Refinement& refinement) {
    double exact = 0.0;
    double coarse = 0.0;
    for (std::size_t pair = 0; pair < refinement.is_exact.size(); ++pair) {
        if (refinement.is_exact[pair] == 0) continue;
        exact += refinement.oc.condensed[pair];
        coarse += refinement.coarse.oc.condensed[pair];
    }
    return exact > 0.0 && coarse > 0.0 ? exact / coarse : 1.0;
}

}  // namespace

Refinement begin_refinement(std::vector<std::shared_ptr<const PatternCode>> codes,
                            const PerceptualModelParams& params, const PredictOptions& options) {
    Refinement refinement;
    refinement.codes = std::move(codes);
    refinement.params = params;
    refinement.nc = nc_matrix(refinement.codes, params, options);
    KnownPairs known = known_oc(refinement.codes, params, options);
    refinement.oc = std::move(known.matrix);
    refinement.is_exact.assign(refinement.oc.condensed.size(), 1);
    for (const std::size_t pair : known.open) refinement.is_exact[pair] = 0;
    refinement.is_made.resize(tile_count(refinement.codes.size()));
    measure_lengths(refinement);
    find_made(refinement);
    return refinement;
}

double open_cells(const Refinement& refinement, std::size_t tile) {
    if (refinement.is_made[tile] != 0) return 0.0;
    double cells = 0.0;
    for_each_open_pair(refinement, tile, [&](std::size_t i, std::size_t j, std::size_t) {
        const bool is_trimmed = refinement.is_silent[i] != 0 && refinement.is_silent[j] != 0;
        const auto whole = static_cast<double>(refinement.codes[i]->samples);
        cells += is_trimmed ? refinement.own_length[i] * refinement.own_length[j] : whole * whole;
    });
    return cells;
}

double open_cells(const Refinement& refinement) {
    double cells = 0.0;
    for (std::size_t tile = 0; tile < refinement.is_made.size(); ++tile) {
        cells += open_cells(refinement, tile);
    }
    return cells;
}

double exact_share(const Refinement& refinement) {
    if (refinement.is_exact.empty()) return 1.0;
    const auto exact = std::ranges::count(refinement.is_exact, std::uint8_t{1});
    return static_cast<double>(exact) / static_cast<double>(refinement.is_exact.size());
}

std::vector<std::size_t> next_tiles(const Refinement& refinement,
                                    std::span<const std::size_t> wanted, double cells) {
    const std::size_t patterns = refinement.codes.size();
    const std::size_t side = tile_side(patterns);
    // A group of patterns is a side of tiles. The first of it that is wanted says when its turn is.
    std::vector<std::size_t> rank((patterns + side - 1) / side);
    for (std::size_t group = 0; group < rank.size(); ++group) rank[group] = patterns + group;
    for (std::size_t k = wanted.size(); k > 0; --k) {
        if (wanted[k - 1] < patterns) rank[wanted[k - 1] / side] = k - 1;
    }
    std::vector<std::size_t> open;
    for (std::size_t tile = 0; tile < refinement.is_made.size(); ++tile) {
        if (refinement.is_made[tile] == 0) open.push_back(tile);
    }
    std::ranges::stable_sort(open, {}, [&](std::size_t tile) {
        const Tile area = tile_at(patterns, tile);
        return std::minmax({rank[area.row / side], rank[area.column / side]});
    });
    std::size_t count = 0;
    for (double so_far = 0.0; count < open.size(); ++count) {
        so_far += open_cells(refinement, open[count]);
        if (count > 0 && so_far > cells) break;
    }
    open.resize(count);
    return open;
}

bool make_tiles(Refinement& refinement, std::span<const std::size_t> tiles,
                const PredictOptions& options) {
    std::vector<SignalPair> pairs;
    std::vector<std::size_t> places;
    for (const std::size_t tile : tiles) {
        for_each_open_pair(refinement, tile, [&](std::size_t i, std::size_t j, std::size_t pair) {
            pairs.push_back(envelopes_of(*refinement.codes[i], *refinement.codes[j]));
            places.push_back(pair);
        });
    }
    const double waiting_cost = refinement.params.envelope.waiting_cost;
    const auto distances =
        dtw(pairs, {options.threads, waiting_cost, options.stop, options.progress});
    if (options.stop.stop_requested()) return false;
    for (std::size_t k = 0; k < places.size(); ++k) {
        refinement.oc.condensed[places[k]] = distances[k];
        refinement.is_exact[places[k]] = 1;
    }
    for (const std::size_t tile : tiles) refinement.is_made[tile] = 1;
    return true;
}

void take_tile(Refinement& refinement, std::size_t tile, std::span<const double> values) {
    const std::size_t patterns = refinement.codes.size();
    const Tile area = tile_at(patterns, tile);
    put_tile(refinement.oc, area, values);
    for_each_open_pair(refinement, tile, [&](std::size_t, std::size_t, std::size_t pair) {
        refinement.is_exact[pair] = 1;
    });
    refinement.is_made[tile] = 1;
}

Prediction prediction_of(const Refinement& refinement) {
    const bool is_exact =
        std::ranges::find(refinement.is_exact, std::uint8_t{0}) == refinement.is_exact.end();
    if (is_exact || refinement.coarse.oc.condensed.size() != refinement.is_exact.size()) {
        return prediction_of(refinement.codes, refinement.params, refinement.nc, refinement.oc);
    }
    Dissimilarity oc = refinement.oc;
    const double scale = coarse_scale(refinement);
    for (std::size_t pair = 0; pair < refinement.is_exact.size(); ++pair) {
        if (refinement.is_exact[pair] != 0) continue;
        oc.condensed[pair] = scale * refinement.coarse.oc.condensed[pair];
    }
    Prediction mixed =
        prediction_of(refinement.codes, refinement.params, refinement.nc, std::move(oc));
    mixed.envelope_decimation = refinement.coarse.decimation;
    return mixed;
}

}  // namespace tact
