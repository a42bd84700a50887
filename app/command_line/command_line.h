// The command line: arguments in, exit code out.
#pragma once

namespace tact {

// 0 done, 1 bad input (one sentence on standard error), 2 bad usage.
int run_command_line(int argc, const char* const* argv);

}  // namespace tact
