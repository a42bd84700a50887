// Which known word a misspelt one was meant to be.
//
// Source    optimal string alignment distance: Damerau 1964, Levenshtein 1966; letters of either
//           case count as the same
// Valid     words of people's files: the cost grows with the product of the lengths
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace tact {

// The nearest of `known`, of equals the first: at most one slip (a letter more, less, other, or two
// exchanged) a four letters of the word. None where no word is as near.
std::optional<std::string_view> misspelt(std::string_view word,
                                         std::span<const std::string_view> known);

}  // namespace tact
