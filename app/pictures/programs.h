// Other programs that take what we make: whether they are there, and writing to them.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace tact {

// In a folder of PATH.
bool is_installed(const std::string& program);

// All of it; a program that has gone is false, not the end of ours.
bool write_unharmed(std::FILE* to, const void* bytes, std::size_t count);

}  // namespace tact
