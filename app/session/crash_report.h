// What is known of a crash, written by the signal's handler where the next start finds it.
//
// A report has the version, the signal, the stack and the last commands by their names, and nothing
// of the content of a set. Addresses are those of the program's file: addr2line -Cfe tells lines.
//
// Source    signal-safety(7), backtrace(3), whose first call loads a library and is made
// beforehand. Left out  SIGKILL and a loss of power; where a sanitizer or a debugger answers a
// signal, it
//           stays theirs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tact {

// From now on a crash writes the file, over an older one. A path longer than 4,000 bytes is left.
void watch_for_crashes(const std::filesystem::path& file);

// For the report: the newest 16 are kept. The name is a literal, and stays where it is.
void note_command(const char* name);

// A report that nobody has been told of, moved to crash-YYYYMMDD-HHMMSS.txt beside it.
std::optional<std::filesystem::path> take_crash_report(const std::filesystem::path& file);

}  // namespace tact
