// Names that nothing else has: a number is put behind one that is taken.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>

namespace tact {

// Gives names away, each once.
struct UnusedNames {
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, int> last_number;  // of names asked for again

    // "buzz", then "buzz 2", "buzz 3".
    std::string unused(const std::string& wanted);
};

}  // namespace tact
