// The files of this folder, compiled into the program.
#pragma once

#include <span>
#include <string_view>

namespace tact {

struct Asset {
    std::string_view path;  // below assets/, e.g. "sets/pm_2023_twelve.tactspace.json"
    std::string_view text;
};

// All of them, by path.
std::span<const Asset> assets();

// The text of one asset. Asking for one that does not exist is a programmer's mistake (assert).
std::string_view asset(std::string_view path);

}  // namespace tact
