#include "devices/device/halt.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <mutex>

namespace tact {

namespace {

constexpr std::array kHaltSignals{SIGTSTP, SIGTTIN, SIGTTOU};
// A look every 20 ms, a packet's period of 30 ms, and a fade.
constexpr timespec kTimeToRest{0, 70'000'000};

std::atomic<std::uint64_t> counted = 0;
std::atomic<void (*)()> say_last = nullptr;

void listen_for(int signal, void (*answer)(int)) {
    struct sigaction action {};
    action.sa_handler = answer;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void rest_and_halt(int signal) {
    const int fault_before = errno;
    rest_all();
    listen_for(signal, SIG_DFL);
    sigset_t only_this;
    sigset_t before;
    sigemptyset(&only_this);
    sigaddset(&only_this, signal);
    raise(signal);
    pthread_sigmask(SIG_UNBLOCK, &only_this, &before);  // here the program is halted
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    listen_for(signal, rest_and_halt);
    errno = fault_before;
}

}  // namespace

const char* const kHalted = " was put to rest when the program was halted: play again";

void rest_before_halts() {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    for (const int signal : kHaltSignals) {
        struct sigaction before {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
        listen_for(signal, rest_and_halt);
    }
}

// The other threads run on meanwhile: they see the count, and put to rest what they drive. The last
// words come after whatever was on its way.
void rest_all() {
    counted.fetch_add(1);
    if (const auto say = say_last.load()) say();
    nanosleep(&kTimeToRest, nullptr);
    if (const auto say = say_last.load()) say();
}

void call_before_halts(void (*before_halt)()) { say_last = before_halt; }

std::uint64_t halts() { return counted.load(); }

}  // namespace tact
