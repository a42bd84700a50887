// Programs that this one starts.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

// Starts a program that is found as a shell finds it, without a terminal. What it says goes to a
// file; default: nowhere.
Expected<pid_t> started(std::vector<std::string> words,
                        const std::filesystem::path& said = "/dev/null");

}  // namespace tact
