// A page starts no programs.
#include "app/session/session.h"

namespace tact {

Expected<pid_t> started(std::vector<std::string> words, const std::filesystem::path&) {
    return Error{words[0] + " cannot be started from a browser"};
}

std::optional<int> ended(pid_t, const std::stop_token&) { return std::nullopt; }

std::filesystem::path running_program() { return {}; }

}  // namespace tact
