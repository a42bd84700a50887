// The few words inside the numbers of a lesson, in its language: "3 of 28" is "3 von 28" in German.
//
// Input     a number as value_of() writes it; a code such as "de" or "de-AT"
// Output    in a language that is not listed, the number unchanged
// Left out  names of receptor types, units, decimal signs: a card has those of the pictures.
#pragma once

#include <string>
#include <string_view>

namespace tact {

std::string number_in(std::string number, std::string_view language);

}  // namespace tact
