// What people said of a set's patterns, as it is kept with the set: who counts of them, and which
// patterns are others than were felt. Window, command line and Python compare and train with it.
//
// Input     the set that was felt, as it is meant: what files or a device make of its patterns has
//           the same names, and says nothing of what was edited
// Output    ratings in the order of the set's patterns
// Valid     whoever is kept has passed who_counts() before: a simulated participant who is kept
//           beside people was included by name, and stays so
// Exact     same set, same answer.
#pragma once

#include "model/common/expected.h"
#include "model/set/pattern_set.h"
#include "model/study/who_counts.h"

namespace tact {

// Errors: those of study_of() and of who_counts().
Expected<Counted> set_people(const PatternSet& meant, const CountRule& who = {});

}  // namespace tact
