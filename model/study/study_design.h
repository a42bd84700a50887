// A study that asks people how alike patterns feel: which patterns, how often, with what pauses and
// words. It belongs to the set.
//
// Source    pairs: Lim & Park 2023, section 6.1 (all pairs four times, one pair of identical
//           patterns, who is to be rated above 80; a rest of one second; here three such pairs);
//           sorting: Ward 1977, Ternes & MacLean 2008.
// Left out  who took part and what they said: model/study/study_record.h.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/common/units.h"

namespace tact {

enum class StudyOrder {
    full,     // the publication's: every pair as often, in random order
    adaptive  // model/study/adaptive_order.h: the same pairs, in an order that settles the map
              // early
};

// Who does not notice that two patterns are the same is not counted.
struct AttentionRule {
    double above = 80.0;       // an identical pair is noticed with a similarity above this
    int failures_allowed = 0;  // number that may be missed

    bool operator==(const AttentionRule&) const = default;
};

// By default. The publication has one, which one in five who answer blindly pass
// (chance_to_pass()).
inline constexpr int kAttentionPairs = 3;

struct StudyDesign {
    std::vector<std::string> patterns;      // names of those that take part; none: all of the set
    int repetitions = 4;                    // of every pair
    int attention_pairs = kAttentionPairs;  // of a pattern with itself, each another as far as
                                            // there are others
    int seed = 1;
    StudyOrder order = StudyOrder::full;
    double gap_s = 1.0;      // between two vibrations, at least
    double rest_s = 1.0;     // after each vibration of the training
    int break_every = 66;    // trials; 0: no breaks
    double masking = 0.0;    // level of the pink noise, of full scale; 0: none
    std::string headphones;  // id of the output that it is on; never the actuator's
    AttentionRule attention;
    std::string instructions;  // empty: instructions_of()
    std::string consent;       // empty: consent_of()
    // Groups in each round of sorting; 0: as many as the person likes. Empty: sorting_rounds().
    std::vector<int> groups;

    bool operator==(const StudyDesign&) const = default;
};

namespace limits {
inline constexpr Range kRepetitions{1, 100};
inline constexpr Range kAttentionPairs{0, 100};
inline constexpr Range kStudySeed{0, 1e9};
inline constexpr Range kPauseS{0, 60};
inline constexpr Range kBreakEvery{0, 100'000};
inline constexpr Range kSimilarity{0, 100};
inline constexpr Range kGroups{0, 500};
inline constexpr std::size_t kMaxRounds = 20;
inline constexpr std::size_t kMaxStudyPatterns = 500;
}  // namespace limits

// The chance that who answers blindly, each whole number of the slider as likely, misses at most as
// many identical pairs as are allowed: binomial, exact.
double chance_to_pass(int attention_pairs, const AttentionRule& rule);

// "0.78 % of those who answer blindly": the same in words.
std::string words_on_chance(int attention_pairs, const AttentionRule& rule);

// The words shown, the design's own or the standard ones.
std::string instructions_of(const StudyDesign& design);
std::string consent_of(const StudyDesign& design);

// Number of trials of the main phase: pairs x repetitions, and attention pairs.
std::size_t trial_count(const StudyDesign& design, std::size_t patterns);

// Minutes that a participant will take. 18 s a trial of two patterns of one second, as the
// publication's 265 trials in 80 minutes; longer patterns add what feeling both twice takes.
double predicted_minutes(const StudyDesign& design, std::size_t patterns, double duration_s);

}  // namespace tact
