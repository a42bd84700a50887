// Finding in a library: by words, and by a shape of strength over time that somebody draws.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/library/library.h"

namespace tact {

// Places of the entries that have every word somewhere: in their name, description, tags, file,
// format or licence. Upper and lower case are one; no word finds all.
std::vector<std::size_t> found_by_words(const Library& library, std::string_view words);

// Strengths at equal steps from the beginning to the end, straight lines between, as a shape whose
// largest is 1; none of fewer than two, of negative ones, or of nothing but zeros.
std::optional<StrengthShape> shape_through(const std::vector<double>& strengths);

// Root of the mean squared difference: 0 of the same shape, at most 1.
double shape_difference(const StrengthShape& a, const StrengthShape& b);

}  // namespace tact
