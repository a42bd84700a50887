// What the thread of one connection does: reads, answers, closes.
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "devices/http/connections.h"

namespace tact {

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
