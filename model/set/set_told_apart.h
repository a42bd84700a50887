// Trials of a set's patterns: as they are noted, which of them still count, and what they say
// beside a verdict by PM.
//
// Source    PM of a pair is another one as soon as the set has another pattern or model: the
//           answers are taken at the PM that their pairs have now. An answer does not count once
//           one of its two patterns was edited (felt_versions.h) or removed.
// Input     PM of the set as it is, in the order of its patterns
// Output    sentences, empty if there is nothing that can be said. They stand beside PM, which
//           never depends on them
// Valid     renders the patterns of the trials, so: once after an edit, not once a frame
// Exact     same input, same answer.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"

namespace tact {

// The answers as a set keeps them, with the versions of the patterns in it.
ToldApart noted_trials(const PatternSet& set, ToldApart about, std::span<const OddAnswer> answers);

// The answers that still count, at their pairs' PM of now.
ToldApart still_told(const PatternSet& set, const ToldApart& told, const Dissimilarity& pm);

// The newest trials that say something: kFewestOddTrials answers count; simulated ones only if no
// person was asked.
struct UsableTrials {
    std::size_t place = 0;  // in set.told_apart
    ToldApart told;         // the answers that count
};
std::optional<UsableTrials> newest_told(const PatternSet& set, const Dissimilarity& pm);

// "On phone Kim, pairs at PM 9 were told apart in about 62 % of trials (one person, 20 trials)."
std::string told_apart_words(const PatternSet& set, const Dissimilarity& pm, double pm_of_pair);

// What there is to say of the same trials besides, for a tooltip: how many were right, the
// threshold, who and when, how many do not count any more.
std::string told_apart_help(const PatternSet& set, const Dissimilarity& pm);

}  // namespace tact
