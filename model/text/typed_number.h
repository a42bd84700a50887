// What a person means by what is typed where a number stands.
//
// Input     "1.5", "1,5", "1.3 g", "0.8g", "0.5 s" where ms are asked for; and changes of the
// number
//           that is there: "*2", "/4", "-10%", "+3dB"
// Output    a finite number within its range, or a sentence that says what was expected
// Valid     a sign before a number without % or dB is the number's own: "-10" is minus ten and
//           "+0.1" a tenth, but "-10%" is a tenth less than the number that is there
// Left out  sums, thousands' separators, degrees of any unit not in the table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/common/units.h"

namespace tact {

// What an entry takes.
struct NumberRules {
    Range allowed;
    std::string_view unit{};  // what the number is in, as it is written behind it: "g", "Hz", "ms"
    bool whole = false;
};

struct TypedNumber {
    double value = 0.0;
    std::string remark{};            // where it is not what was typed, why not
    std::optional<double> factor{};  // of a change: for other numbers that it is meant for as well
};

// `present` is what changes are of.
Expected<TypedNumber> typed_number(std::string_view text, double present, const NumberRules& rules);

// What a format of printf writes behind the number: "g" of "%.3g g".
std::string_view unit_in(std::string_view format);

// The unit that words begin with, such as "s until the motion begins"; empty: none.
std::string_view leading_unit(std::string_view words);

// A number as an entry shows it.
std::string shown_number(const char* format, double value);

}  // namespace tact
