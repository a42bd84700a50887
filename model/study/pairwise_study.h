// Which pairs a participant of a pairwise study feels, in which order and on which sides.
//
// Source    Lim & Park 2023, section 6.1. Passes (every pair once, in random order) one after the
//           other are ours: who stops early has rated all pairs about as often.
// Output    every pair the stated number of times; each pattern left as often as right, within one
//           over all passes; never a pair twice in a row; pairs of identical patterns spread evenly
// Valid     3 patterns and more: the only pair of two cannot but follow itself
// Exact     same plan, same trials, on any machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/study/study_design.h"

namespace tact {

// Two patterns by their positions; the same twice where attention is tested.
struct Trial {
    std::size_t left = 0;
    std::size_t right = 0;

    bool is_attention() const { return left == right; }
    bool operator==(const Trial&) const = default;
};

struct TrialPlan {
    std::size_t patterns = 0;
    int repetitions = 4;
    int attention_pairs = 1;  // at most as many as other trials; more are left out
    std::uint64_t seed = 1;
};

TrialPlan plan_of(const StudyDesign& design, std::size_t patterns, std::uint64_t seed);

// Seed of one participant, from their code and the study's seed alone.
std::uint64_t participant_seed(int study_seed, const std::string& participant);

// All patterns once, in any order: the buttons of the training.
std::vector<std::size_t> training_order(const TrialPlan& plan);

std::vector<Trial> trial_list(const TrialPlan& plan);

// The pair at a position of the condensed order with its sides in a pass (0 ..).
Trial sided_trial(const TrialPlan& plan, std::size_t pair, std::size_t pass);

// Before which of the other trials (0 ..) stands which attention pair, ascending.
struct AttentionPlace {
    std::size_t before = 0;
    std::size_t pattern = 0;
};
std::vector<AttentionPlace> attention_places(const TrialPlan& plan);

}  // namespace tact
