// The design of a study, described (model/text/described.h), in the order of files.
#pragma once

#include <array>

#include "model/study/study_design.h"
#include "model/text/described.h"

namespace tact {

inline constexpr std::array<const char*, 2> kStudyOrders{"full", "adaptive"};

namespace numbers {

// clang-format off
inline constexpr Number kRepetitions{.key = "repetitions", .label = "Repetitions", .format = "%.0f",
    .range = limits::kRepetitions, .slider = {1, 8}, .snap = 1,
    .help = "How often every pair is rated. The publication: 4."};
// Files hold it wherever they hold a design: its default was once another.
inline constexpr Number kAttentionPairs{.key = "attention_pairs", .label = "Identical pairs",
    .format = "%.0f", .range = limits::kAttentionPairs, .slider = {0, 10}, .snap = 1,
    .help = "Trials with one pattern on both buttons, each time another: who does not rate them as "
            "the same was not attending. The publication: 1, which one in five blind answers "
            "pass.", .kept = Kept::always};
inline constexpr Number kStudySeed{.key = "seed", .label = "Seed", .format = "%.0f",
    .range = limits::kStudySeed, .slider = {0, 100}, .snap = 1,
    .help = "The order of trials and sides is drawn from the seed and the participant's code: the "
            "same again for the same two."};
inline constexpr Number kGap{.key = "gap_s", .label = "Gap", .format = "%.2f s",
    .range = limits::kPauseS, .slider = {0.0, 3.0}, .step = 0.1, .snap = 0.1,
    .help = "Silence between two vibrations, at least. The publication: 1 s."};
inline constexpr Number kRest =
    kGap.as("rest_s", "Pause in training", "Silence after every vibration of the training.");
inline constexpr Number kBreakEvery{.key = "break_every", .label = "Break every",
    .format = "%.0f trials", .range = limits::kBreakEvery, .slider = {0, 200}, .snap = 1,
    .help = "Trials between two breaks; 0: none."};
inline constexpr Number kMasking{.key = "masking", .label = "Masking noise", .format = "%.0f %%",
    .range = {0.0, 1.0}, .slider = {0.0, 1.0}, .times = 100.0, .step = 5.0, .snap = 1.0,
    .help = "Level of pink noise, of full scale, on the participant's headphones, so that the "
            "actuator is felt and not heard; 0: off. It needs a second sound output."};
inline constexpr Number kPassMark{.key = "above", .label = "Pass mark", .format = "%.0f of 100",
    .range = limits::kSimilarity, .slider = {50, 100}, .snap = 1,
    .help = "Similarity that identical patterns must exceed, or the participant is not counted. "
            "The publication: 80.", .kept = Kept::always};
inline constexpr Number kFailuresAllowed{.key = "failures_allowed", .label = "Allowed failures",
    .format = "%.0f", .range = limits::kAttentionPairs, .slider = {0, 5}, .snap = 1,
    .help = "Identical pairs that a participant may miss and still be counted.",
    .kept = Kept::always};
inline constexpr Number kRoundGroups{.key = "groups", .label = "Groups", .format = "%.0f",
    .range = limits::kGroups, .slider = {0, 10}, .snap = 1,
    .help = "Groups in a round; 0: as many as a person likes."};
// clang-format on

}  // namespace numbers

template <class Visit>
void describe(Of<AttentionRule>, Visit&& visit) {
    visit(numbers::kPassMark, &AttentionRule::above);
    visit(numbers::kFailuresAllowed, &AttentionRule::failures_allowed);
}

template <class Visit>
void describe(Of<StudyDesign>, Visit&& visit) {
    visit(ManyOf{"patterns", 0, limits::kMaxStudyPatterns}, &StudyDesign::patterns);
    visit(numbers::kRepetitions, &StudyDesign::repetitions);
    visit(numbers::kStudySeed, &StudyDesign::seed);
    visit("order", OneOf{kStudyOrders}, &StudyDesign::order);
    visit(numbers::kGap, &StudyDesign::gap_s);
    visit(numbers::kRest, &StudyDesign::rest_s);
    visit(numbers::kBreakEvery, &StudyDesign::break_every);
    visit(numbers::kMasking, &StudyDesign::masking);
    visit(Text{"headphones", true}, &StudyDesign::headphones);
    visit("attention", &StudyDesign::attention);
    visit(Text{"instructions"}, &StudyDesign::instructions);
    visit(Text{"consent"}, &StudyDesign::consent);
    visit(ManyOf{"groups", 0, limits::kMaxRounds}, numbers::kRoundGroups, &StudyDesign::groups);
    visit(numbers::kAttentionPairs, &StudyDesign::attention_pairs);
}

}  // namespace tact
