// What is wrong with a line of a file, as one sentence.
#pragma once

#include <cstddef>
#include <string>

#include "model/common/expected.h"

namespace tact {

// "FILE:LINE: FAULT"; lines count from 1.
inline Error at_line(const std::string& file, std::size_t line, const std::string& fault) {
    return Error{file + ":" + std::to_string(line) + ": " + fault};
}

}  // namespace tact
