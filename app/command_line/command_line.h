// The command line: arguments in, exit code out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

// The window on some sets, where no command is given.
using RunWindow = Expected<Done> (*)(const std::vector<std::filesystem::path>& sets);

// 0 done, 1 bad input (one sentence on standard error), 2 bad usage.
int run_command_line(int argc, const char* const* argv, RunWindow run_window);

// What --help says of each command.
struct CommandHelp {
    std::string name;
    std::string summary;
    std::string text;  // all of it, with the usage and the options
};
std::vector<CommandHelp> command_help();

}  // namespace tact
