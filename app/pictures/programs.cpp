#include "app/pictures/programs.h"

#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace tact {

bool is_installed(const std::string& program) {
    const char* folders = std::getenv("PATH");
    std::string left = folders == nullptr ? "" : folders;
    while (!left.empty()) {
        const std::size_t end = left.find(':');
        std::error_code none;
        if (std::filesystem::exists(std::filesystem::path(left.substr(0, end)) / program, none)) {
            return true;
        }
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return false;
}

bool write_unharmed(std::FILE* to, const void* bytes, std::size_t count) {
    sigset_t pipe;
    sigset_t before;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, &before);
    const bool good = std::fwrite(bytes, 1, count, to) == count && std::fflush(to) == 0;
    const timespec now{};
    if (!good) sigtimedwait(&pipe, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return good;
}

}  // namespace tact
