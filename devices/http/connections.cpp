#include "devices/http/connections.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "devices/http/timed_socket.h"

namespace tact {

namespace {

constexpr std::size_t kMostGivingWay = 64;  // which are about to end
constexpr auto kLastWords = std::chrono::milliseconds(500);
constexpr auto kNoRoomRest = std::chrono::milliseconds(10);  // the system has no number left
}  // namespace

Connections::Connections(OwnedSocket listening, ConnectionLimits limits, Answer answer)
    : listening_(std::move(listening)),
      limits_(limits),
      answer_(std::move(answer)),
      woken_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    takes_ = start_small_thread(taker_, [this] { run(); });
}

Connections::~Connections() {
    std::unique_lock lock(mutex_);
    ends_ = true;
    lock.unlock();
    wake();
    if (takes_) pthread_join(taker_, nullptr);
    listening_ = OwnedSocket();
    lock.lock();
    for (const Place& place : places_) {
        if (place.reads && place.socket) shutdown(place.socket.number(), SHUT_RD);
    }
    const auto all_done = [this] { return std::ranges::all_of(places_, &Place::is_done); };
    changed_.wait_for(lock, kLastWords, all_done);
    for (const Place& place : places_) {
        if (place.socket) shutdown(place.socket.number(), SHUT_RDWR);
    }
    changed_.wait(lock, all_done);
    lock.unlock();
    join_done();
}

std::size_t Connections::count() const {
    const std::lock_guard lock(mutex_);
    return places_.size();
}

void Connections::wake() const {
    const std::uint64_t one = 1;
    // A counter that is full has woken it, too.
    [[maybe_unused]] const auto written = write(woken_.number(), &one, sizeof one);
}

void Connections::run() {
    while (true) {
        std::array<pollfd, 2> asked{pollfd{listening_.number(), POLLIN, 0},
                                    pollfd{woken_.number(), POLLIN, 0}};
        poll(asked.data(), asked.size(), -1);
        std::uint64_t count = 0;
        [[maybe_unused]] const auto emptied = read(woken_.number(), &count, sizeof count);
        join_done();
        {
            const std::lock_guard lock(mutex_);
            if (ends_) return;
        }
        if (asked[0].revents != 0) take_one();
    }
}

void Connections::take_one() {
    OwnedSocket socket = accepted_socket(listening_);
    const bool is_full = !make_way();
    if (socket && !is_full) return start(std::move(socket));
    if (!socket && (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM)) {
        std::this_thread::sleep_for(kNoRoomRest);
    }
}

// Whether there is a place for one more.
bool Connections::make_way() {
    const std::lock_guard lock(mutex_);
    const auto stays = [](const Place& place) { return !place.is_done && !place.gave_way; };
    const auto staying = static_cast<std::size_t>(std::ranges::count_if(places_, stays));
    if (staying < limits_.most) return true;
    if (places_.size() >= limits_.most + kMostGivingWay) return false;
    const auto oldest = std::ranges::find_if(
        places_, [&](const Place& place) { return stays(place) && place.reads; });
    if (oldest == places_.end()) return false;
    oldest->gave_way = true;
    shutdown(oldest->socket.number(), SHUT_RDWR);
    return true;
}

void Connections::start(OwnedSocket socket) {
    const std::lock_guard lock(mutex_);
    Place& place = places_.emplace_back();
    place.room = this;
    place.socket = std::move(socket);
    if (!start_small_thread(place.thread, [&place] { place.room->serve(place); })) {
        places_.pop_back();
    }
}

void Connections::join_done() {
    std::list<Place> done;
    {
        const std::lock_guard lock(mutex_);
        for (auto place = places_.begin(); place != places_.end();) {
            const auto here = place++;
            if (here->is_done) done.splice(done.end(), places_, here);
        }
    }
    for (const Place& place : done) pthread_join(place.thread, nullptr);
}

// What the thread of one connection does: reads, answers, closes.

namespace {

// Bytes of a refused request that are read, so that its sender hears that it is refused.
constexpr std::size_t kMostPassedOver = 65'536;
constexpr double kPassedOverS = 1.0;

SocketMoment in_s(double seconds) {
    return std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               std::chrono::duration<double>(seconds));
}

void pass_over_rest(int socket, double seconds) {
    shutdown(socket, SHUT_WR);
    std::array<char, 4096> bytes{};
    const SocketMoment deadline = in_s(seconds);
    for (std::size_t count = 0; count < kMostPassedOver;) {
        const std::string_view came = read_until(socket, bytes, deadline);
        if (came.empty()) return;
        count += came.size();
    }
}

}  // namespace

void Connections::serve(Place& place) {
    try {
        const RequestBytes request = read_request(place.socket.number());
        bool goes_on = false;
        {
            const std::lock_guard lock(mutex_);
            goes_on = !place.gave_way && !request.bytes.empty();
            place.reads = !goes_on;
        }
        if (goes_on) answer(place, request);
    } catch (...) {
        // No memory, say: this connection ends without an answer.
    }
    finish(place);
}

RequestBytes Connections::read_request(int socket) const {
    RequestBytes request;
    std::array<char, 4096> bytes{};
    const SocketMoment deadline = in_s(limits_.request_s);
    while (true) {
        const std::string_view came = read_until(socket, bytes, deadline);
        if (came.empty()) break;
        if (!take_in(request, came)) return request;
    }
    end_of_bytes(request);
    return request;
}

void Connections::answer(Place& place, const RequestBytes& request) {
    const int socket = place.socket.number();
    const std::string bytes = answer_(request, handshake_s(socket));
    const bool taken = write_until(socket, bytes, in_s(limits_.answer_s));
    if (!taken || request.refused == 0) return;
    {
        const std::lock_guard lock(mutex_);
        place.reads = true;
    }
    pass_over_rest(socket, std::min(kPassedOverS, limits_.request_s));
}

void Connections::finish(Place& place) {
    {
        const std::lock_guard lock(mutex_);
        place.socket = OwnedSocket();
        place.is_done = true;
        changed_.notify_all();
    }
    wake();
}

}  // namespace tact
