// What a list is narrowed to by a few typed words: a part of a name, or whole words of what the
// pattern is: "0.4g", "60 Hz", "8Hz", "x--x", "steady", "locked", "layers",
// and what its note has behind "Tags:".
//
// Valid     any text; upper and lower case are one, a unit may stand apart from its number
// Left out  recordings' numbers; further carriers than the first two
#pragma once

#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// In lower case.
std::vector<std::string> words_of(const Vibration& vibration);

// An empty search finds all.
class VibrationSearch {
  public:
    explicit VibrationSearch(const std::string& search);
    bool finds(const Vibration& vibration) const;

  private:
    std::string text_;                // as typed, in lower case
    std::vector<std::string> terms_;  // its words, units joined to their numbers
};

}  // namespace tact
