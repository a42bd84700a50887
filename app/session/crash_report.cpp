#include "app/session/session.h"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

#include "app/session/program_version.h"
#include "devices/device/crash_signals.h"

namespace tact {

namespace {

// A handler has no arguments of ours: what it needs has to lie where it can find it.
std::array<char, 4096> report_path{};
std::array<std::atomic<const char*>, 16> last_commands{};
std::atomic<std::size_t> commands_noted = 0;

struct Crash {
    int signal;
    const char* name;
};

constexpr std::array<Crash, 5> kCrashes{{{SIGSEGV, "SIGSEGV, memory that is not there"},
                                         {SIGBUS, "SIGBUS, a file that became shorter"},
                                         {SIGFPE, "SIGFPE, a whole number divided by zero"},
                                         {SIGILL, "SIGILL, an instruction unknown here"},
                                         {SIGABRT, "SIGABRT, a broken law of the program"}}};

void put(int file, std::string_view text) {
    [[maybe_unused]] const ssize_t written = write(file, text.data(), text.size());
}

void put_commands(int file) {
    const std::size_t noted = commands_noted.load();
    const std::size_t kept = std::min(noted, last_commands.size());
    put(file, "\nLast commands, the newest first\n");
    for (std::size_t k = 1; k <= kept; ++k) {
        const char* name = last_commands[(noted - k) % last_commands.size()].load();
        if (name == nullptr) continue;
        put(file, "  ");
        put(file, {name, std::strlen(name)});
        put(file, "\n");
    }
    if (kept == 0) put(file, "  none\n");
}

void report_crash(int signal) {
    const int file = open(report_path.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file >= 0) {
        put(file, kProgramVersion);
        put(file, " ended by ");
        for (const Crash& crash : kCrashes) {
            if (crash.signal == signal) put(file, crash.name);
        }
        put(file, "\n\nStack\n");
        std::array<void*, 64> frames{};
        const int depth = backtrace(frames.data(), static_cast<int>(frames.size()));
        backtrace_symbols_fd(frames.data(), depth, file);
        put_commands(file);
        close(file);
    }
    // The handler was for once: now the signal does what it would have done.
    raise(signal);
}

// A stack for the main thread: one that is used up leaves no room for the handler.
void give_handler_a_stack() {
    static std::array<char, 65536> place{};
    stack_t stack{};
    stack.ss_sp = place.data();
    stack.ss_size = place.size();
    sigaltstack(&stack, nullptr);
}

}  // namespace

void watch_for_crashes(const std::filesystem::path& file) {
    const std::string path = file.string();
    if (path.empty() || path.size() > 4000) return;
    std::copy(path.begin(), path.end() + 1, report_path.begin());
    std::array<void*, 1> loads{};
    backtrace(loads.data(), 1);
    give_handler_a_stack();
    for (const Crash& crash : kCrashes) {
        struct sigaction before {};
        if (sigaction(crash.signal, nullptr, &before) != 0 || !may_be_taken(before)) continue;
        struct sigaction action {};
        action.sa_handler = report_crash;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
        sigemptyset(&action.sa_mask);
        sigaction(crash.signal, &action, nullptr);
    }
}

void note_command(const char* name) {
    last_commands[commands_noted % last_commands.size()] = name;
    ++commands_noted;
}

std::optional<std::filesystem::path> take_crash_report(const std::filesystem::path& file) {
    if (!is_there(file)) return std::nullopt;
    const auto kept = unused_file(file.parent_path(), "crash-", ".txt");
    std::error_code fault;
    std::filesystem::rename(file, kept, fault);
    if (fault) return std::nullopt;
    return kept;
}

}  // namespace tact
