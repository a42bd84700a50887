#include "devices/hid/last_words.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <mutex>

#include "devices/device/halt.h"

namespace tact {

namespace {

// A handler has no arguments of ours: what it needs has to lie where it can find it.
struct Place {
    std::atomic<int> descriptor = -1;
    std::atomic<bool> taken = false;
    std::atomic<std::size_t> size = 0;  // 0: nothing to say
    std::array<std::uint8_t, 80> bytes{};
};

std::array<Place, 16> places;

// All that end a program unasked, but for SIGKILL, which nobody hears.
constexpr std::array kSignals{SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGABRT, SIGTERM, SIGHUP,
                              SIGINT,  SIGQUIT, SIGSYS, SIGXCPU, SIGXFSZ, SIGALRM, SIGPIPE};

// What answered each signal before, and does so once the words are said.
std::array<struct sigaction, kSignals.size()> others{};

void say_all() {
    for (const Place& place : places) {
        const std::size_t size = place.size.load();
        const int descriptor = place.descriptor.load();
        if (size == 0 || descriptor < 0) continue;
        // Twice: one may be lost on the air.
        for (int k = 0; k < 2; ++k) {
            [[maybe_unused]] const ssize_t written = write(descriptor, place.bytes.data(), size);
        }
    }
}

std::atomic<bool> is_over = false;

void say_at_exit() {
    is_over = true;
    say_all();
}

void say_last_words(int signal) {
    say_at_exit();
    // The handler was for once: now the signal does what it would have done.
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        if (kSignals[k] == signal) sigaction(signal, &others[k], nullptr);
    }
    raise(signal);
}

// What answers a crash by writing a report, and by nothing else, comes after the last words. A
// debugger or a sanitizer asks for details of the signal, and it stays theirs.
bool comes_after(const struct sigaction& before) {
    return (before.sa_flags & SA_SIGINFO) == 0 &&
           (before.sa_handler == SIG_DFL ||
            (before.sa_handler != SIG_IGN && (before.sa_flags & SA_RESETHAND) != 0));
}

void listen() {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    // A library that gives up calls exit(): Xlib does where its display dies.
    [[maybe_unused]] static const int at_exit = std::atexit(say_at_exit);
    call_before_halts(say_all);
    rest_before_halts();
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        struct sigaction before {};
        if (sigaction(kSignals[k], nullptr, &before) != 0 || !comes_after(before)) continue;
        if (before.sa_handler == say_last_words) continue;
        others[k] = before;
        struct sigaction action {};
        action.sa_handler = say_last_words;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
        sigemptyset(&action.sa_mask);
        sigaction(kSignals[k], &action, nullptr);
    }
}

}  // namespace

bool has_said_last_words() { return is_over.load(); }

LastWords::LastWords(const std::string& path) {
    listen();
    for (std::size_t k = 0; k < places.size(); ++k) {
        bool free = false;
        if (!places[k].taken.compare_exchange_strong(free, true)) continue;
        place_ = static_cast<int>(k);
        places[k].descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        return;
    }
}

LastWords::~LastWords() {
    if (place_ < 0) return;
    Place& place = places[static_cast<std::size_t>(place_)];
    place.size = 0;
    const int descriptor = place.descriptor.exchange(-1);
    if (descriptor >= 0) close(descriptor);
    place.taken = false;
}

void LastWords::set(std::span<const std::uint8_t> packet) {
    if (place_ < 0) return;
    Place& place = places[static_cast<std::size_t>(place_)];
    place.size = 0;
    if (packet.size() > place.bytes.size()) return;
    std::copy(packet.begin(), packet.end(), place.bytes.begin());
    place.size = packet.size();
}

}  // namespace tact
