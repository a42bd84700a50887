// Names: that they are unique, and how long they may be.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tact {

// Every frame lays out the names that are on screen.
inline constexpr std::size_t kMaxNameBytes = 1000;

// What is wrong with the length of a name, or empty: "expected a name of at most ..".
std::string name_fault(const std::string& name);

// Positions of the first name that is there already, and of where it was: {earlier, later}.
std::optional<std::pair<std::size_t, std::size_t>> first_equal(
    const std::vector<std::string>& names);

// Gives names away, each once: a number is put behind one that is taken.
struct UnusedNames {
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, int> last_number;  // of names asked for again

    // "buzz", then "buzz 2", "buzz 3"; cut before the number where it would be too long with it.
    std::string unused(const std::string& wanted);
};

}  // namespace tact
