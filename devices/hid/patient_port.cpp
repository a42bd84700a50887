#include "devices/hid/patient_port.h"

#include <pthread.h>

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace tact {

namespace {

// Where one thread lays down a packet and another one takes it up.
struct Desk {
    std::function<bool(std::span<const std::uint8_t>)> write;
    std::mutex mutex;  // guards the rest
    std::condition_variable changed;
    std::optional<Packet> next;
    bool is_busy = false;
    bool was_taken = false;
    bool is_closed = false;
};

void serve(const std::shared_ptr<Desk>& desk) {
    rank_before_drawing();
    std::unique_lock lock(desk->mutex);
    for (;;) {
        desk->changed.wait(lock, [&] { return desk->next || desk->is_closed; });
        if (!desk->next) return;
        const Packet packet = *std::exchange(desk->next, std::nullopt);
        lock.unlock();
        const bool was_taken = desk->write(packet);
        lock.lock();
        desk->was_taken = was_taken;
        desk->is_busy = false;
        desk->changed.notify_all();
    }
}

// The thread ends with the port; one that does not come back is left alone with its desk.
struct Server {
    std::shared_ptr<Desk> desk;
    std::thread thread;

    explicit Server(std::shared_ptr<Desk> at) : desk(std::move(at)), thread(serve, desk) {}
    ~Server() {
        bool is_busy = false;
        {
            const std::lock_guard lock(desk->mutex);
            desk->is_closed = true;
            is_busy = desk->is_busy;
        }
        desk->changed.notify_all();
        is_busy ? thread.detach() : thread.join();
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
};

// How long a packet is waited for, as things stand.
struct Patience {
    std::chrono::milliseconds whole;
    std::shared_ptr<const std::atomic<bool>> hurries;

    bool is_over(std::chrono::steady_clock::time_point since, bool was_late) const {
        const bool is_short = was_late || (hurries && *hurries);
        const auto now = is_short ? std::min(whole, kHurriedPatience) : whole;
        return std::chrono::steady_clock::now() >= since + now;
    }
};

// In short turns: it may become urgent meanwhile.
bool becomes_free(Desk& desk, std::unique_lock<std::mutex>& lock, const Patience& patience,
                  bool was_late) {
    const auto since = std::chrono::steady_clock::now();
    while (desk.is_busy) {
        if (patience.is_over(since, was_late)) return false;
        desk.changed.wait_for(lock, std::chrono::milliseconds(5));
    }
    return true;
}

bool hand_over(Desk& desk, std::span<const std::uint8_t> packet, const Patience& patience) {
    std::unique_lock lock(desk.mutex);
    if (!becomes_free(desk, lock, patience, true)) return false;
    desk.next = Packet(packet.begin(), packet.end());
    desk.is_busy = true;
    desk.changed.notify_all();
    return becomes_free(desk, lock, patience, false) && desk.was_taken;
}

}  // namespace

// A page has no ranks, and without threads not even the call.
void rank_before_drawing() {
#ifndef __EMSCRIPTEN__
    sched_param param{};
    param.sched_priority = 1;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
#endif
}

HidPort patient_port(HidPort port, std::chrono::milliseconds patience,
                     std::shared_ptr<const std::atomic<bool>> hurries) {
    auto desk = std::make_shared<Desk>();
    desk->write = std::move(port.write);
    port.write =
        [server = std::make_shared<Server>(std::move(desk)),
         waits = Patience{patience, std::move(hurries)}](std::span<const std::uint8_t> packet) {
            return hand_over(*server->desk, packet, waits);
        };
    return port;
}

}  // namespace tact
