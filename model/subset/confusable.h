// Pairs that people may confuse: by how far apart they are, or by what is felt of each number.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ConfusablePair {
    std::size_t a = 0;
    std::size_t b = 0;  // > a
    double dissimilarity = 0.0;

    bool operator==(const ConfusablePair&) const = default;
};

// Pairs not above the threshold, closest first, at most `most`; empty if the threshold is not
// finite.
std::vector<ConfusablePair> confusable_pairs(const Dissimilarity& dissimilarity, double threshold,
                                             std::size_t most);

// The dissimilarity below which a share of the pairs lies; NaN of none.
double threshold_at(const Dissimilarity& dissimilarity, double share);

// What quantiles are taken of: dissimilarities that are known, ascending.
std::vector<double> sorted_values(const Dissimilarity& dissimilarity);

// The pairs of which no number differs by a felt step of the set (model/pattern/felt_steps.h), the
// closest first; recordings only where they are the same to the sample. Empty for most sets.
std::vector<ConfusablePair> pairs_within_a_step(const PatternSet& set,
                                                const Dissimilarity& dissimilarity);
bool within_a_step(const PatternSet& set, std::size_t a, std::size_t b);

// Whether two patterns are felt as two, in a word: the one scale of the window, the terminal, pages
// and files. It is of felt steps alone, as nobody has measured at which PM pairs are told apart.
enum class PairVerdict {
    same,   // no number differs by a felt step, nor anything else: people would confuse the two
    close,  // none by kClearSteps
    clear,
    shape  // they differ in what no step measures: rhythm, curves, transients; or one is a
           // recording
};
inline constexpr PairVerdict kPairVerdicts[] = {PairVerdict::same, PairVerdict::close,
                                                PairVerdict::clear, PairVerdict::shape};
inline constexpr double kClearSteps = 2.0;  // [ours]
PairVerdict pair_verdict(const PatternSet& set, std::size_t a, std::size_t b);
const char* words_of(PairVerdict verdict);     // "may be confused"
const char* sentence_of(PairVerdict verdict);  // "No number differs by two felt steps."

}  // namespace tact
