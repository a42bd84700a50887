// The results of trials in plain English.
//
// Output    whole sentences; of what the data do not say they tell that it is not known. PM of 10
//           and more in whole numbers, below with two digits; shares in whole percent
// Valid     95 % intervals throughout, of one person on one device
#pragma once

#include <string>

#include "model/told_apart/told_apart_results.h"

namespace tact {

// "12", "1,200", "0.45".
std::string pm_digits(double pm);

// "15 of 20 trials were right: 75 % (53 to 89 %). A guess is right in a third of trials."
std::string share_words(const ToldApartResults& results);

// "Pairs beyond PM 12 (8 to 19) were told apart in at least 75 % of trials.", or what can be said
// in its place: the threshold is below or above all that was asked, or not known.
std::string threshold_words(const ToldApartResults& results);

// "pairs at PM 9 were told apart in about 62 % of trials"; of a PM that was not among those asked:
// "pairs at PM 2, less than any that was asked, may be told apart in about 40 % of trials".
std::string words_at(const ToldApartResults& results, double pm);

// "one person, 20 trials"; of nobody "simulated, 20 trials".
std::string asked_words(const ToldApart& told, const ToldApartResults& results);

}  // namespace tact
