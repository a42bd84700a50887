// TCP sockets whose every step ends at a moment, however slow the other side is.
//
// Source    socket(7), tcp(7), poll(2). SIGPIPE is never raised (MSG_NOSIGNAL)
// Left out  IPv6, names of hosts, encryption
#pragma once

#include <pthread.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "model/common/expected.h"

namespace tact {

using SocketMoment = std::chrono::steady_clock::time_point;

// Closed with this value.
class OwnedSocket {
  public:
    explicit OwnedSocket(int number = -1) : number_(number) {}
    ~OwnedSocket();
    OwnedSocket(OwnedSocket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    OwnedSocket& operator=(OwnedSocket&& other) noexcept;

    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

  private:
    int number_;
};

// Listens on the interface of that IPv4 address alone; port 0: any that is free.
Expected<OwnedSocket> listening_socket(const std::string& ipv4, int port);

int port_of(const OwnedSocket& socket);

// A connection that waits to be taken; empty if nobody waits, or there is no room for it.
OwnedSocket accepted_socket(const OwnedSocket& listening);

// What has come, once something has; empty: the other side is done, or the moment has passed.
std::string_view read_until(int socket, std::span<char> into, SocketMoment deadline);

// False: not all was taken by then.
bool write_until(int socket, std::string_view bytes, SocketMoment deadline);

// How long the connection's own way there and back took, as the kernel measured; 0: not known.
double handshake_s(int socket);

// A thread with a small stack: some hundreds of them wait most of the time.
//
// Source    pthread_attr_setstacksize(3). std::thread has no such choice, and takes 8 MB of
//           addresses each, all of which are memory where an audio library locks what the
//           process has

// False: the system has no room for it. To be joined by pthread_join.
bool start_small_thread(pthread_t& thread, std::function<void()> run);

}  // namespace tact
