// Words about the raters, for every place that shows a number made from their ratings.
//
// They name the raters, how many of them count, and the best agreement a metric can reach. Stale or
// synthetic ratings are labelled beside every number.
#pragma once

#include <string>
#include <vector>

#include "model/evaluation/metric_comparison.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"

namespace tact {

// "rho", or "synthetic rho", "stale rho", "synthetic, stale rho".
std::string of_people(const std::string& quantity, const NumberMark& mark);
// "rating (2 participants left out)", for places that do not name the raters otherwise.
std::string of_counted(const std::string& quantity, const NumberMark& mark);

// A line on the set's own ratings: "people.csv (2 participants left out): 18 participants, 6 of
// them synthetic, 72 passes, 9 of 12 patterns rated, 36 of 66 pairs".
std::string people_text(const PatternSet& set, const RatedPeople& people);

// Two ceilings: the agreement a metric can reach with the mean of the ratings, and that of one
// person with the others. Only the first is a ceiling for metrics.
std::string ceiling_text(const Reliability& reliability, const NumberMark& mark);

// The agreement of the best possible metric with single people, by its two bounds; empty if it
// cannot be computed.
std::string single_ceiling_text(const Ceilings& ceilings, const NumberMark& mark);

}  // namespace tact
