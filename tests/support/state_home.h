// XDG_STATE_HOME for the time of a test: where sessions are kept.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace tact {

struct StateHome {
    explicit StateHome(const std::filesystem::path& folder) {
        ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
    }
    ~StateHome() {
        if (before) ::setenv("XDG_STATE_HOME", before->c_str(), 1);
        if (!before) ::unsetenv("XDG_STATE_HOME");
    }
    StateHome(const StateHome&) = delete;
    StateHome& operator=(const StateHome&) = delete;

    std::optional<std::string> before = [] {
        const char* set = std::getenv("XDG_STATE_HOME");
        return set == nullptr ? std::nullopt : std::optional<std::string>(set);
    }();
};

}  // namespace tact
