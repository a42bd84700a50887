// Names that are to be unique.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tact {

// Positions of the first name that is there already, and of where it was: {earlier, later}.
std::optional<std::pair<std::size_t, std::size_t>> first_equal(
    const std::vector<std::string>& names);

// Gives names away, each once: a number is put behind one that is taken.
struct UnusedNames {
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, int> last_number;  // of names asked for again

    // "buzz", then "buzz 2", "buzz 3".
    std::string unused(const std::string& wanted);
};

}  // namespace tact
