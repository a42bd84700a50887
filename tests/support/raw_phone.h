// A phone of a test: raw sockets on the loopback, by hand, so that it can also send what no browser
// would.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tact::raw_phone {

inline constexpr int kMostWaitS = 120;  // for what must come: only what hangs waits so long

struct Reply {
    int status = 0;  // 0: the connection was closed without an answer
    std::string head;
    std::string body;
};

inline Reply reply_of(const std::string& bytes) {
    Reply reply;
    const std::size_t end = bytes.find("\r\n\r\n");
    if (!bytes.starts_with("HTTP/1.1 ") || end == std::string::npos) return reply;
    reply.status = std::stoi(bytes.substr(9, 3));
    reply.head = bytes.substr(0, end + 4);
    reply.body = bytes.substr(end + 4);
    return reply;
}

class Connection {
  public:
    explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        const timeval patience{kMostWaitS, 0};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        is_open_ =
            connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~Connection() {
        if (socket_ >= 0) ::close(socket_);
    }
    Connection(Connection&& other) noexcept
        : socket_(std::exchange(other.socket_, -1)), is_open_(other.is_open_) {}

    bool is_open() const { return is_open_; }
    int socket() const { return socket_; }

    // False: the other side takes no more.
    bool send(std::string_view bytes) const {
        while (!bytes.empty()) {
            const auto count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (count <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
        return true;
    }

    // All until the other side closes.
    std::string all() const {
        std::string bytes;
        char some[4096];
        for (ssize_t count = 1; count > 0;) {
            count = recv(socket_, some, sizeof some, 0);
            if (count > 0) bytes.append(some, static_cast<std::size_t>(count));
        }
        return bytes;
    }
    Reply reply() const { return reply_of(all()); }

    // Whether there is something to read, or an end, right now.
    bool has_news() const {
        pollfd asked{socket_, POLLIN, 0};
        return poll(&asked, 1, 0) > 0;
    }

  private:
    int socket_;
    bool is_open_ = false;
};

// The parts of "http://127.0.0.1:4711/TOKEN/".
struct Place {
    int port = 0;
    std::string path;  // "/TOKEN/"

    explicit Place(const std::string& address) {
        const std::size_t colon = address.rfind(':');
        const std::size_t slash = address.find('/', colon);
        port = std::stoi(address.substr(colon + 1, slash - colon - 1));
        path = address.substr(slash);
    }
};

inline std::string request_text(const std::string& method, const std::string& path,
                                const std::string& body = {}) {
    std::string text = method + " " + path + " HTTP/1.1\r\nHost: test\r\n";
    if (!body.empty() || method == "POST") {
        text += "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
                "\r\n";
    }
    return text + "\r\n" + body;
}

// What comes back of any bytes.
inline Reply sent(const Place& place, const std::string& bytes) {
    const Connection connection(place.port);
    connection.send(bytes);
    return connection.reply();
}

inline Reply asked(const Place& place, const std::string& method, const std::string& name,
                   const std::string& body = {}) {
    return sent(place, request_text(method, place.path + name, body));
}

}  // namespace tact::raw_phone
