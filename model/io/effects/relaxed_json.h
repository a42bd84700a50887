// JSON as people write it by hand, made strict: actuator configurations are JSON5, and AHAP with a
// comma behind the last element is taken by the players of the field.
//
// Output    comments gone, single quotes doubled, bare keys quoted, commas before ] and } gone;
// line
//           breaks stay where they are, so that lines of errors are those of the file
// Left out  numbers that JSON does not have (hexadecimal, .5, +1), escaped line breaks in texts.
#pragma once

#include <string>
#include <string_view>

namespace tact {

std::string strict_json(std::string_view relaxed);

}  // namespace tact
