#include "devices/hid/emergency_packet.h"

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <system_error>
#include <thread>

#include "devices/device/crash_signals.h"
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

// What answered each signal before, and does so once the packets are sent.
std::array<struct sigaction, kSignals.size()> others{};

void send_all() {
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

// A driver that hangs keeps a write for good; the program is to end all the same.
constexpr int kAnswerMs = 200;

bool has_packet_to_send() {
    return std::ranges::any_of(places, [](const Place& place) { return place.size.load() > 0; });
}

void say_at_exit() {
    is_over = true;
    if (!has_packet_to_send()) return;
    static std::atomic<bool> is_said = false;
    try {
        std::thread([] {
            send_all();
            is_said = true;
        }).detach();
    } catch (const std::system_error&) {
        return send_all();
    }
    constexpr timespec kMillisecond{0, 1'000'000};
    for (int k = 0; k < kAnswerMs && !is_said; ++k) nanosleep(&kMillisecond, nullptr);
}

std::atomic<int> dying_of = 0;

// The handler was for once: now the signal does what it would have done.
void die() {
    const int signal = dying_of.load();
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        if (kSignals[k] == signal) sigaction(signal, &others[k], nullptr);
    }
    raise(signal);
}

// On whatever thread, where the signal may be blocked.
void die_unheard(int) {
    sigset_t only_this;
    sigemptyset(&only_this);
    sigaddset(&only_this, dying_of.load());
    pthread_sigmask(SIG_UNBLOCK, &only_this, nullptr);
    die();
}

void set_time_limit(int limit_ms) {
    struct sigaction action {};
    action.sa_handler = die_unheard;
    sigemptyset(&action.sa_mask);
    sigaction(SIGALRM, &action, nullptr);
    sigset_t only_this;
    sigemptyset(&only_this);
    sigaddset(&only_this, SIGALRM);
    pthread_sigmask(SIG_UNBLOCK, &only_this, nullptr);
    const itimerval limit{{0, 0}, {0, 1000 * limit_ms}};
    setitimer(ITIMER_REAL, &limit, nullptr);
}

void send_emergency_packets(int signal) {
    is_over = true;
    dying_of = signal;
    if (has_packet_to_send()) {
        set_time_limit(kAnswerMs);
        send_all();
        const itimerval none{};
        setitimer(ITIMER_REAL, &none, nullptr);
    }
    die();
}

// What answers a crash by writing a report, and by nothing else, comes after the packets.
bool comes_after(const struct sigaction& before) {
    return (before.sa_flags & SA_SIGINFO) == 0 && before.sa_handler != SIG_IGN &&
           (before.sa_flags & SA_RESETHAND) != 0;
}

void listen() {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    // A library that gives up calls exit(): Xlib does where its display dies.
    [[maybe_unused]] static const int at_exit = std::atexit(say_at_exit);
    call_before_halts(send_all);
    rest_before_halts();
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        struct sigaction before {};
        if (sigaction(kSignals[k], nullptr, &before) != 0) continue;
        if (before.sa_handler == send_emergency_packets) continue;
        if (!comes_after(before) && !may_be_taken(before)) continue;
        others[k] = before;
        if (is_a_librarys(before)) others[k] = {};
        struct sigaction action {};
        action.sa_handler = send_emergency_packets;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
        sigemptyset(&action.sa_mask);
        sigaction(kSignals[k], &action, nullptr);
    }
}

}  // namespace

bool has_sent_emergency_packets() { return is_over.load(); }

EmergencyPacket::EmergencyPacket(const std::string& path) {
    listen();
    for (std::size_t k = 0; k < places.size(); ++k) {
        bool free = false;
        if (!places[k].taken.compare_exchange_strong(free, true)) continue;
        place_ = static_cast<int>(k);
        places[k].descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        return;
    }
}

EmergencyPacket::~EmergencyPacket() {
    if (place_ < 0) return;
    Place& place = places[static_cast<std::size_t>(place_)];
    place.size = 0;
    const int descriptor = place.descriptor.exchange(-1);
    if (descriptor >= 0) close(descriptor);
    place.taken = false;
}

void EmergencyPacket::set(std::span<const std::uint8_t> packet) {
    if (place_ < 0) return;
    Place& place = places[static_cast<std::size_t>(place_)];
    place.size = 0;
    if (packet.size() > place.bytes.size()) return;
    std::copy(packet.begin(), packet.end(), place.bytes.begin());
    place.size = packet.size();
}

}  // namespace tact
