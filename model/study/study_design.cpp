#include "model/study/study_design.h"

#include <algorithm>
#include <cmath>

#include "model/dissimilarity/dissimilarity.h"
#include "model/text/numbers.h"

namespace tact {

std::string instructions_of(const StudyDesign& design) {
    if (!design.instructions.empty()) return design.instructions;
    return "You will feel two vibrations at a time and say how similar they are.\n\n"
           "Press A and B to feel them, as often as you like. Then move the slider: 0 means "
           "totally different, 100 means the same. There is no right or wrong answer; what "
           "counts is what you feel.\n\n"
           "First you will get to know all vibrations. Breaks are offered on the way, and you "
           "may stop at any time.";
}

std::string consent_of(const StudyDesign& design) {
    if (!design.consent.empty()) return design.consent;
    return "I take part of my own free will and may stop at any time without giving a reason. My "
           "answers are kept without my name, under the code below.";
}

std::size_t trial_count(const StudyDesign& design, std::size_t patterns) {
    if (patterns < 2) return 0;
    return pair_count(patterns) * static_cast<std::size_t>(design.repetitions) +
           static_cast<std::size_t>(design.attention_pairs);
}

double chance_to_pass(int attention_pairs, const AttentionRule& rule) {
    constexpr double kAnswers = 101.0;  // 0 .. 100
    const double above = std::clamp(100.0 - std::floor(rule.above), 0.0, kAnswers);
    const double passes = above / kAnswers;
    // Sums the chances of exactly 0, 1, 2 ... misses.
    double sum = 0.0;
    double ways = 1.0;
    for (int misses = 0; misses <= std::min(rule.failures_allowed, attention_pairs); ++misses) {
        double chance = ways;
        for (int k = 0; k < attention_pairs; ++k) chance *= k < misses ? 1.0 - passes : passes;
        sum += chance;
        ways *= static_cast<double>(attention_pairs - misses) / static_cast<double>(misses + 1);
    }
    return std::min(sum, 1.0);
}

std::string words_on_chance(int attention_pairs, const AttentionRule& rule) {
    const double percent = 100.0 * chance_to_pass(attention_pairs, rule);
    const std::string digits = percent >= 99.5 ? "100" : significant_digits(percent, 2);
    return digits + " % of those who answer blindly";
}

double predicted_minutes(const StudyDesign& design, std::size_t patterns, double duration_s) {
    constexpr double kPerTrialS = 18.0;
    constexpr double kFeelsPerTrial = 4.0;
    const double longer_s = kFeelsPerTrial * (duration_s - 1.0);
    const double trial_s = kPerTrialS + longer_s;
    const double training_s = static_cast<double>(patterns) * (duration_s + design.rest_s + 1.0);
    return (static_cast<double>(trial_count(design, patterns)) * trial_s + training_s) / 60.0;
}

}  // namespace tact
