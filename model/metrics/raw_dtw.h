// Dynamic time warping of the waveforms themselves, with the variants that the field uses.
//
// Confidence  [H] algorithm, [M] that the paper means this variant: MATLAB's dtw(x, y)
// Source    Berndt & Clifford 1994; band: Sakoe & Chiba 1978.
// Input     two waveforms of any lengths, not padded; g
// Output    g (g^2 where squared, without the root): the sum along the best path, or that per step
// Valid     10,000 samples each are 1e8 cells: 0.1 s with the default, 0.5 s with other variants
// Left out  slope weights. No triangle inequality holds: D must not be pruned with it.
// Exact     symmetric; the default gives the bits of model/dtw/dtw.h
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace tact {

enum class DtwCost {
    absolute,  // |x - y|
    squared
};

enum class DtwNormalisation {
    none,            // the paper's, as far as can be told
    path_length,     // of equally good steps the diagonal, then those of the shorter path
    sum_of_lengths,  // no change of order in a set of one length
};

struct RawDtwParams {
    DtwCost cost = DtwCost::absolute;
    bool takes_root = false;  // of the sum of squared costs, before it is normalised
    DtwNormalisation normalisation = DtwNormalisation::none;
    // Sakoe & Chiba: how far a path may leave the straight line, in samples of the shorter signal;
    // never less than half a one, or unequal lengths would have no path.
    std::optional<std::size_t> band_samples;

    bool operator==(const RawDtwParams&) const = default;
};

// True where model/dtw/dtw.h computes it, which is many times faster for the pairs of a set.
bool is_plain(const RawDtwParams& params);

// As in model/dtw/dtw.h, two signals of none are at distance 0, and none is infinitely far from
// some.
double raw_dtw(std::span<const double> x, std::span<const double> y,
               const RawDtwParams& params = {});

// What a plain distance of two signals of these lengths becomes where params ask for a share.
double normalised_dtw(double distance, std::size_t x_samples, std::size_t y_samples,
                      const RawDtwParams& params);

}  // namespace tact
