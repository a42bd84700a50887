// Text in which {{WORD REST}} stands for something that is made.
//
// Valid     a placeholder on one line, without braces in it
// Output    an Error as "NAME:LINE: expected .."
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

// What a placeholder stands for; an Error says what was expected instead, without a full stop.
using PartOf = std::function<Expected<std::string>(std::string_view word, std::string_view rest)>;

// `name` is that of the text, for messages.
Expected<std::string> filled(std::string_view text, std::string_view name, const PartOf& part_of);

}  // namespace tact
