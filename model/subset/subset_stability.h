// How sure a subset and a map are, when what is uncertain in the model is drawn at random.
//
// Source    ours: thresholds of each receptor type even within 6 dB either way, as between people
//           and probes; each choice that is one of two taken the other way in one draw of four;
//           orders, kernels and weights near their values. All lie about the model in use, which is
//           the first draw itself.
// Input     the set, and its map, to which each draw's map is turned
// Output    the share of draws in which each member stays, and where each draw puts each point
// Left out  slopes of the firing rates, densities; whether some choices are likelier than others.
// Exact     same seed, same numbers, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/subset/subset.h"

namespace tact {

struct StabilityParams {
    std::size_t draws = 100;
    std::uint64_t seed = 1;
    double threshold_db = 6.0;   // either way, of each type by itself
    double weight_step = 0.1;    // either way, of each weight: a step of the training's grid
    double turned_share = 0.25;  // of draws in which a choice is not the model's; 0: none is
    double time_limit_s = 5.0;   // for the subset of each draw
    int threads = 0;             // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1
};

// The model of one draw; of the first, `params`.
PerceptualModelParams drawn_params(const PerceptualModelParams& params,
                                   const StabilityParams& stability, std::size_t draw);

struct Stability {
    std::size_t draws = 0;
    Subset subset;                        // by the model as it is
    std::vector<double> share_picked;     // of each pattern of the set, in 0..1
    double share_same = 0.0;              // of draws with this very subset
    double share_weakest = 0.0;           // of draws in which its weakest pair stays its weakest
    std::vector<Eigen::Matrix3Xd> moves;  // of each point, a column a draw, from where it is
};

// Members, and who else was picked in some draw; the oftenest first.
std::vector<std::size_t> ever_picked(const Stability& stability);

// `points`: the map of the set, n x 2 or n x 3. Envelopes are compared at 1 kHz. None when stopped.
std::optional<Stability> subset_stability(const PatternSet& set, const SubsetProblem& problem,
                                          const Subset& subset, const Eigen::MatrixXd& points,
                                          const StabilityParams& params);

}  // namespace tact
