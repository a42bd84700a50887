// The command line: arguments in, exit code out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

// The window on some sets, where no command is given.
using RunWindow = Expected<Done> (*)(const std::vector<std::filesystem::path>& sets);

// 0: all that was asked for is there. Else one sentence on standard error, and 1: bad input or a
// failure, 2: bad usage, 128 and the number of the signal: interrupted.
int run_command_line(int argc, const char* const* argv, RunWindow run_window);

// What --help says of each command.
struct CommandHelp {
    std::string name;
    std::string summary;
    std::string text;  // all of it, with the usage and the options
};
std::vector<CommandHelp> command_help();

}  // namespace tact
