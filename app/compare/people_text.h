// What is said of those who rated, wherever a number is made from their ratings.
//
// Whose they are, how many count and how many do not, and how far a metric can agree with them
// stand together; that nobody was asked, or of other patterns, is said beside every number itself.
#pragma once

#include <string>
#include <vector>

#include "model/evaluation/metric_comparison.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"

namespace tact {

// "0.87", with a true minus; a dash where there is no number.
std::string digits(double value, int decimals);

// "rho", or "synthetic rho", "stale rho", "synthetic, stale rho".
std::string of_people(const std::string& quantity, const NumberMark& mark);
// "rating (2 participants left out)", where it stands without anything that says whose it is.
std::string of_counted(const std::string& quantity, const NumberMark& mark);

// "people.csv (2 participants left out): 18 participants, 6 of them synthetic, 72 passes, 9 of 12
// patterns rated, 36 of 66 pairs", of the set's own ratings.
std::string people_text(const PatternSet& set, const RatedPeople& people);

// What a metric can reach with the mean of the ratings, and what one person reaches: two ceilings,
// of which only the first is one for the metrics.
std::string ceiling_text(const Reliability& reliability, const NumberMark& mark);

// What the best metric there could be has with single people, by its two bounds; empty where nobody
// can tell.
std::string single_ceiling_text(const Ceilings& ceilings, const NumberMark& mark);

}  // namespace tact
