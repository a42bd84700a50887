#include "devices/http/timed_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <memory>
#include <system_error>
#include <utility>

namespace tact {

namespace {

constexpr int kWaitingConnections = 512;  // that came at once, and are not taken yet

bool set_option(int socket, int level, int name) {
    const int on = 1;
    return setsockopt(socket, level, name, &on, sizeof on) == 0;
}

Error socket_fault(const std::string& ipv4, int port) {
    const std::string why = std::generic_category().message(errno);
    return Error{"cannot listen on " + ipv4 +
                 (port > 0 ? ", port " + std::to_string(port) : std::string{}) + ": " + why};
}

// False: the moment has passed.
bool is_ready_by(int socket, short what, SocketMoment deadline) {
    while (true) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) return false;
        pollfd asked{socket, what, 0};
        const int answer =
            poll(&asked, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 60'000)));
        if (answer > 0) return true;
        if (answer < 0 && errno != EINTR) return false;
    }
}

bool is_later() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

OwnedSocket::~OwnedSocket() {
    if (number_ >= 0) ::close(number_);
}

OwnedSocket& OwnedSocket::operator=(OwnedSocket&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

Expected<OwnedSocket> listening_socket(const std::string& ipv4, int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (port < 0 || port > 65'535 || inet_pton(AF_INET, ipv4.c_str(), &address.sin_addr) != 1) {
        return Error{"expected an IPv4 address of this computer and a port of 0 to 65535, got " +
                     ipv4 + " and " + std::to_string(port)};
    }
    OwnedSocket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    // A port that was left a moment ago is free again.
    if (!socket || !set_option(socket.number(), SOL_SOCKET, SO_REUSEADDR) ||
        bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(socket.number(), kWaitingConnections) != 0) {
        return socket_fault(ipv4, port);
    }
    return socket;
}

int port_of(const OwnedSocket& socket) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

OwnedSocket accepted_socket(const OwnedSocket& listening) {
    OwnedSocket socket(accept4(listening.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    // An answer is written at once: nothing is to be waited for.
    if (socket) set_option(socket.number(), IPPROTO_TCP, TCP_NODELAY);
    return socket;
}

std::string_view read_until(int socket, std::span<char> into, SocketMoment deadline) {
    while (is_ready_by(socket, POLLIN, deadline)) {
        const auto count = recv(socket, into.data(), into.size(), MSG_DONTWAIT);
        if (count > 0) return {into.data(), static_cast<std::size_t>(count)};
        if (count == 0 || !is_later()) return {};
    }
    return {};
}

bool write_until(int socket, std::string_view bytes, SocketMoment deadline) {
    while (!bytes.empty()) {
        if (!is_ready_by(socket, POLLOUT, deadline)) return false;
        const auto count = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && !is_later()) return false;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

double handshake_s(int socket) {
    tcp_info info{};
    socklen_t size = sizeof info;
    if (getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return 0.0;
    return 1e-6 * info.tcpi_rtt;
}

namespace {

constexpr std::size_t kStackBytes = 256 * 1024;

void* run_task(void* task) {
    const std::unique_ptr<std::function<void()>> owned(static_cast<std::function<void()>*>(task));
    (*owned)();
    return nullptr;
}

}  // namespace

bool start_small_thread(pthread_t& thread, std::function<void()> run) {
    auto task = std::make_unique<std::function<void()>>(std::move(run));
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_attr_setstacksize(&attributes, kStackBytes);
    const bool started = pthread_create(&thread, &attributes, run_task, task.get()) == 0;
    pthread_attr_destroy(&attributes);
    if (started) (void)task.release();  // the thread's now
    return started;
}

}  // namespace tact
