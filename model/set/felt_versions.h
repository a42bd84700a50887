// Which version of a pattern was felt or measured: ratings and twins belong to it, and say so once
// the pattern is another.
//
// Output    a version is 16 hexadecimal digits, of the samples: what changes nothing that is felt
//           changes no version. Empty: not recorded, as in files of before.
// Left out  whose ratings they are (set_ratings.h)
#pragma once

#include <string>
#include <vector>

#include "model/set/pattern_set.h"
#include "model/study/ratings.h"
#include "model/study/study_record.h"

namespace tact {

std::string version_of(const Vibration& vibration);

// What is no longer as it was felt or measured, by name, in the order of the set.
struct StalePatterns {
    std::vector<std::string> edited;         // were rated, and are others since
    std::vector<std::string> unrecorded;     // were rated, nobody knows in which version
    std::vector<std::string> gone;           // were rated, and are no longer in the set
    std::vector<std::string> twins;          // measure what is another since
    std::vector<std::string> unknown_twins;  // measure nobody knows which version
    std::vector<std::string> lone_twins;     // measure what is no longer in the set

    bool operator==(const StalePatterns&) const = default;
};
StalePatterns stale_patterns(const PatternSet& set);

// What follows the name of what a twin measures: ", which was edited since". Empty: nothing.
std::string words_on_twin(const StalePatterns& stale, const std::string& twin);

// "stale" of a twin, "edited" of a rated pattern, as a mark in a list; empty: none.
std::string mark_in_list(const StalePatterns& stale, const std::string& name);

// Patterns that are others in `set` than when the ratings were given, into `study`.
void note_edited(RatingStudy& study, const PatternSet& set);

// Ratings that a set takes from a study are of the versions in the study (default: the set's now).
void note_versions(std::vector<Ratings>& ratings, const RatingStudy& study, const PatternSet& set);

// An edit made `after` of `before`: what was rated or measured in a version that is not recorded
// was so, as far as anybody knows, in that before the edit.
void keep_versions(const PatternSet& before, PatternSet& after);

// The set as a study's header tells of it: its name, the patterns that take part, what they are.
void describe_set(StudyHeader& header, const PatternSet& set);

}  // namespace tact
