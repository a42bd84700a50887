// Programs that this one starts.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

// Starts a program that is found as a shell finds it, without a terminal. What it says goes to a
// file; default: nowhere.
Expected<pid_t> started(std::vector<std::string> words,
                        const std::filesystem::path& said = "/dev/null");

// How it ended, as waitpid says it; none: it was asked to stop, or is nobody's child here.
std::optional<int> ended(pid_t process, const std::stop_token& stop);

// The file of the running program; empty where the system does not say.
std::filesystem::path running_program();

}  // namespace tact
