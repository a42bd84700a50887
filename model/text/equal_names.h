// Names that are to be unique.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tact {

// Positions of the first name that is there already, and of where it was: {earlier, later}.
std::optional<std::pair<std::size_t, std::size_t>> first_equal(
    const std::vector<std::string>& names);

}  // namespace tact
