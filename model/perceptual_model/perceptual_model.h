// PM: the predicted perceptual dissimilarity of every pair of a set.
//
//     PM_ij = w_NC rank(NC)_ij + w_OC rank(OC)_ij
//
// Source    Lim & Park 2023, section 5.3.
// Input     waveforms at 10 kHz; shorter ones count as followed by zeros, to the longest of them
// Output    NC, OC and PM of every pair. PM depends on the set: adding a pattern changes all of it.
// Left out  everything but intensity, spectrum and rhythm as one fingertip feels them.
// Exact     same input, same bits, on any number of threads; also when results are reused.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/dtw/dtw.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/neural_coding.h"
#include "model/signal/waveform.h"

namespace tact {

// One pattern as the model sees it: as long as it sounds itself.
struct PatternCode {
    Waveform waveform;             // without the zeros at its end
    std::size_t samples = 0;       // that were coded: with the zeros up to the longest
    NeuralCode neural;             // without what is behind its last spike
    std::vector<double> envelope;  // without the zeros at its end
    bool is_quick = false;         // an approximation (quick_neural_code)
};

struct Prediction {
    PerceptualModelParams params;
    std::size_t envelope_decimation = 1;  // more than 1: a preview, not PM
    std::vector<std::shared_ptr<const PatternCode>> codes;
    Dissimilarity nc;
    Dissimilarity oc;
    std::vector<double> nc_rank;  // condensed
    std::vector<double> oc_rank;
    Dissimilarity pm;
};

struct PredictOptions {
    int threads = 0;  // 0: all cores
    // 10: envelopes at 1 kHz, a hundredth of the work; about 1 % of pair orders flip. For previews.
    std::size_t envelope_decimation = 1;
    // Codes of short patterns in a set with a long one are approximations. For previews.
    bool quick_codes = false;
    // An earlier prediction; codes and pairs of unchanged patterns are taken from it.
    const Prediction* previous = nullptr;
    std::size_t samples = 0;  // that all waveforms are padded to; default: those of the longest
    std::stop_token stop;
    std::function<void(double)> progress;  // share of the work done, 0..1, from any thread
};

// The codes of all waveforms; none when stopped.
std::vector<std::shared_ptr<const PatternCode>> pattern_codes(std::span<const Waveform> waveforms,
                                                              const PerceptualModelParams& params,
                                                              const PredictOptions& options);

// With the zeros up to the longest.
Waveform coded_waveform(const PatternCode& code);

// The envelopes of two, with the zeros up to the longest.
SignalPair envelopes_of(const PatternCode& a, const PatternCode& b);

// Whether any receptor answers to it, and the places of those to which none does.
bool is_felt(const PatternCode& code);
std::vector<std::size_t> unfelt(std::span<const std::shared_ptr<const PatternCode>> codes);

// The two parts, unranked; a single pattern gives a matrix of no pairs.
Dissimilarity nc_matrix(std::span<const std::shared_ptr<const PatternCode>> codes,
                        const PerceptualModelParams& params, const PredictOptions& options);
Dissimilarity oc_matrix(std::span<const std::shared_ptr<const PatternCode>> codes,
                        const PerceptualModelParams& params, const PredictOptions& options);

// A matrix of the pairs that were known already, and where the others belong.
struct KnownPairs {
    Dissimilarity matrix;
    std::vector<std::size_t> open;  // condensed
};

// The OC that options.previous has of these codes.
KnownPairs known_oc(std::span<const std::shared_ptr<const PatternCode>> codes,
                    const PerceptualModelParams& params, const PredictOptions& options);

// PM from its two parts, whatever they were computed from.
Prediction prediction_of(std::vector<std::shared_ptr<const PatternCode>> codes,
                         const PerceptualModelParams& params, Dissimilarity nc, Dissimilarity oc);

// How much of a pair's PM comes of each part: the weighted ranks' shares. A part in which the two
// do not differ has none, though pairs that are tied at 0 have a rank; without any, both are 0.
struct PartShares {
    double nc = 0.0;
    double oc = 0.0;
};
PartShares part_shares(const Prediction& prediction, std::size_t pair);

// All of it; nothing when stopped. Codes that are there already save their coding.
std::optional<Prediction> predict(std::vector<std::shared_ptr<const PatternCode>> codes,
                                  const PerceptualModelParams& params,
                                  const PredictOptions& options);
std::optional<Prediction> predict(std::span<const Waveform> waveforms,
                                  const PerceptualModelParams& params,
                                  const PredictOptions& options = {});

// PM of one pair from its ranks in NC and OC.
//
// Source    Lim & Park 2023, section 5.3.
// Exact     equal sums are equal numbers: in doubles 0.1 and 0.3 of two ranks and of their exchange
//           may differ by rounding, and the ranks of PM with them.

// w_NC rank_NC + w_OC rank_OC. Weights, within +-kLargestWeight, count to twelve decimals and ranks
// to halves: a sum of whole numbers.
double pm_of(double nc_rank, double oc_rank, double nc_weight, double oc_weight);

}  // namespace tact
