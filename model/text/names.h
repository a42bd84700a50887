// Names: of files, of their own kind, in the order in which people count.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tact {

// Names of patterns and people as names of files.
//
// Left out  names that differ in case only, which some file systems take for one.

inline constexpr std::size_t kLongestStem = 120;  // bytes; file systems have 255 with the ending

// A name as a file's, without its ending: UTF-8, never empty nor hidden; what file systems refuse,
// and what would steer the terminal that lists it, becomes "-". A longer one is cut between
// characters and gets a number of the whole, so that names that differ behind the cut differ here,
// too.
std::string file_stem(std::string_view name);

// Names: that they are unique, and how long they may be.

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

// The order in which people number things: 2 before 10, in any script.
//
// Left out  alphabets of languages, case: other characters go by their code points.

// A strict total order of UTF-8 texts. Runs of the digits 0-9 compare as numbers of any length;
// names that differ only in leading zeros go by their bytes.
bool naturally_before(std::string_view a, std::string_view b);

}  // namespace tact
