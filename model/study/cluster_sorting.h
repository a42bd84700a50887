// Dissimilarities from people who sort patterns into groups.
//
// Source    Ward 1977; MacLean & Enriquez 2003; Ternes & MacLean 2008: two patterns in one group
//           are the more alike the more groups there were.
// Output    d = 1 - (sum of c over the rounds that put them together) / (sum of c), c the number of
//           groups of a round: 0 always together, 1 never
// Valid     a pair has a say in the rounds in which both were sorted; in none: NaN
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

inline constexpr std::size_t kUnsorted = static_cast<std::size_t>(-1);

// The group of every pattern in one round; kUnsorted where it was not among those sorted.
using Sorting = std::vector<std::size_t>;

std::size_t group_count(const Sorting& sorting);

// Sortings of one participant, each as long as there are patterns.
Dissimilarity sorting_dissimilarity(std::size_t patterns, std::span<const Sorting> sortings);

// The rounds of a study: first as many groups as the person likes (0), then 3, 6, 9, 12 and 15
// without the one nearest to that choice; none with as many groups as patterns, or more.
std::vector<int> sorting_rounds(std::size_t patterns, std::size_t free_choice);

// Rounds as a person writes them: "free, 3, 6". Empty for none; nothing for what is no number from
// 2 to that of the patterns, nor "free" or 0.
std::string rounds_text(const std::vector<int>& rounds);
std::optional<std::vector<int>> rounds_in(std::string_view text, std::size_t patterns);

}  // namespace tact
