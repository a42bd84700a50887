#include "app/session/session.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

namespace tact {

Expected<pid_t> started(std::vector<std::string> words, const std::filesystem::path& said) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, said.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    pid_t process = 0;
    const int fault =
        posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault == 0) return process;
    return Error{words[0] + " cannot be started: " + std::strerror(fault)};
}

std::optional<int> ended(pid_t process, const std::stop_token& stop) {
    int status = 0;
    for (;;) {
        const pid_t which = waitpid(process, &status, WNOHANG);
        if (which == process) return status;
        if (which < 0 && errno != EINTR) return std::nullopt;
        if (stop.stop_requested()) {
            kill(process, SIGTERM);
            waitpid(process, &status, 0);
            return std::nullopt;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

std::filesystem::path running_program() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

}  // namespace tact
