// How far apart the patterns of a set are felt, and which of them nobody feels: what is asked
// before any are picked, grouped, mapped or reported. Window, command line and Python ask here.
//
// Input     the set that people feel: the one that is meant, or what files and a device make of it
// Output    of every pair the value that is written into files (as_ranked): whoever reads the file
//           picks and groups as those who ask here
// Exact     same set, same bits, on any number of threads, also where a prediction is known.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/evaluation/metric_matrix.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

struct PairsRequest {
    Metric metric = Metric::pm;
    bool with_unfelt = true;            // looks for the patterns that nobody feels, too
    const Prediction* known = nullptr;  // of this very set, which saves what it has
    MetricOptions options{};
};

struct SetPairs {
    Dissimilarity apart;
    std::vector<std::size_t> unfelt;  // places to which no receptor answers; empty if not asked for

    bool operator==(const SetPairs&) const = default;
};

// Nothing when stopped.
std::optional<SetPairs> set_pairs(const PatternSet& felt, const PairsRequest& request = {});

// The same of waveforms at 10 kHz that belong to no set, each at its own length; g.
std::optional<SetPairs> set_pairs(std::span<const Waveform> felt,
                                  const PerceptualModelParams& model,
                                  const PairsRequest& request = {});

// The places alone. Nothing when stopped. threads = 0: all cores.
std::optional<std::vector<std::size_t>> unfelt_in(const PatternSet& felt, int threads = 0,
                                                  std::stop_token stop = {});
std::optional<std::vector<std::size_t>> unfelt_in(std::span<const Waveform> felt,
                                                  const PerceptualModelParams& model,
                                                  int threads = 0, std::stop_token stop = {});

}  // namespace tact
