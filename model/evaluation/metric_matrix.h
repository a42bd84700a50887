// The dissimilarity matrix of a set by any metric.
//
// Input     waveforms of one rate, each at its own length. Zeros follow shorter ones, up to the
//           longest of them, as for PM; but DTW takes them as they are.
// Output    0 between equal waveforms; but PM and no-physiology, being sums of ranks, are never 0
//           and depend on the whole set
// Left out  tiles and matrices that fill the memory (model/perceptual_model/tiles.h: PM, NC and OC)
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/evaluation/metric.h"
#include "model/metrics/raw_dtw.h"
#include "model/metrics/spectral_matching.h"
#include "model/metrics/spectral_rmse.h"
#include "model/metrics/spqi.h"
#include "model/metrics/st_sim.h"
#include "model/metrics/temporal_matching.h"
#include "model/metrics/van_rossum.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/signal/waveform.h"

namespace tact {

// How a directional metric becomes symmetric.
enum class Direction {
    mean_of_both,
    first_is_reference  // the upper triangle as it is, the earlier pattern the reference
};

// The choices of each, the defaults being those that are argued in its file.
struct BaselineParams {
    SpectralRmseParams rmse;
    RawDtwParams dtw;
    SpectralMatchingParams msm;
    TemporalMatchingParams mtm;
    StSimParams st_sim;
    SpqiParams spqi;
    VanRossumParams van_rossum;

    bool operator==(const BaselineParams&) const = default;
};

struct MetricOptions {
    BaselineParams baseline;
    Direction direction = Direction::mean_of_both;
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the pairs done, 0..1, from any thread
};

// The distance of every pair; nothing when stopped.
std::optional<Dissimilarity> metric_matrix(Metric metric, std::span<const Waveform> waveforms,
                                           const PerceptualModelParams& params,
                                           const MetricOptions& options = {});

// What average_ranks should be given: the matrix's values, but SPQI with its sign turned where they
// are 1 - SPQI, as they differ in digits that quantising takes away.
std::vector<double> values_to_rank(Metric metric, const Dissimilarity& matrix,
                                   const BaselineParams& params = {});

// The matrix as it is written: pairs that share a rank have one value. Ranks that others make of it
// are then the ones that the metric is compared with people by; all other values keep their bits.
Dissimilarity as_ranked(Metric metric, Dissimilarity matrix, const BaselineParams& params = {});

}  // namespace tact
