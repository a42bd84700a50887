// The exact PM of a set, tile by tile in place of a preview's: what a person looks at first.
//
// Input     codes of the set; OC of their coarse envelopes, or none; what is known of its pairs
// Output    at any time PM of what is exact by then, the rest coarse; PM itself in the end
// Left out  NC in tiles: all of it takes a thousandth of OC's time.
// Exact     in the end the bits of predict(), in whatever order tiles are made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/perceptual_model/perceptual_model.h"

namespace tact {

// The OC of coarse envelopes.
struct CoarseOc {
    Dissimilarity oc;
    std::size_t decimation = 1;
};

struct Refinement {
    std::vector<std::shared_ptr<const PatternCode>> codes;
    PerceptualModelParams params;
    Dissimilarity nc;
    Dissimilarity oc;                     // where it is known
    std::vector<std::uint8_t> is_exact;   // whether it is, of each pair
    std::vector<std::uint8_t> is_made;    // of each tile (tiles.h)
    std::vector<double> own_length;       // samples of each envelope, up to its last zeros
    std::vector<std::uint8_t> is_silent;  // at its end, of each pattern
    CoarseOc coarse;                      // empty: there is no preview
};

// What an earlier prediction knows is exact from the beginning (options.previous). With a stop
// asked for, it is of no use.
Refinement begin_refinement(std::vector<std::shared_ptr<const PatternCode>> codes,
                            const PerceptualModelParams& params, const PredictOptions& options);

// Cells of dynamic time warping that are to be filled yet: of all tiles, or of one.
double open_cells(const Refinement& refinement);
double open_cells(const Refinement& refinement, std::size_t tile);

// Share of the pairs that are exact, 0..1; 1 without pairs.
double exact_share(const Refinement& refinement);

// Tiles to be made next, with at most this number of cells but at least one tile: those with the
// patterns that are wanted first (places, the most wanted first), then by the patterns' order.
// Empty: all are made.
std::vector<std::size_t> next_tiles(const Refinement& refinement,
                                    std::span<const std::size_t> wanted, double cells);

// False where a stop was asked for; nothing has changed then.
bool make_tiles(Refinement& refinement, std::span<const std::size_t> tiles,
                const PredictOptions& options);

// A tile's values from elsewhere, as tile_values() makes them.
void take_tile(Refinement& refinement, std::size_t tile, std::span<const double> values);

// PM as it is known by now: coarse OC stands where none is exact, times what makes it as large as
// the exact values there are. It says so by its envelope_decimation, which is 1 in the end.
Prediction prediction_of(const Refinement& refinement);

}  // namespace tact
