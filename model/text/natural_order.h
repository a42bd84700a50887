// The order in which people number things: 2 before 10, in any script.
//
// Left out  alphabets of languages, case: other characters go by their code points.
#pragma once

#include <string_view>

namespace tact {

// A strict total order of UTF-8 texts. Runs of the digits 0-9 compare as numbers of any length;
// names that differ only in leading zeros go by their bytes.
bool naturally_before(std::string_view a, std::string_view b);

}  // namespace tact
