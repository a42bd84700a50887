// Connections that are taken, read, answered and closed: one request each, on a thread of its own.
//
// Places are bounded. A request must have come in whole within `request_s` however it drips, and
// its answer must have been taken within `answer_s`. Where all places are taken, the connection
// that has been sending its request for longest gives way; if all wait for answers, the new one is
// closed at once. Nobody without a request, of whatever number, keeps those out who have one.
//
// Left out  more than one request a connection: half of all places would be held by phones that
//           have nothing to say, and a browser would find a connection closed as it uses it
// Source    stacks are small, as an audio library may lock all memory of the process
#pragma once

#include <pthread.h>

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <string>

#include "devices/http/request_bytes.h"
#include "devices/http/timed_socket.h"

namespace tact {

struct ConnectionLimits {
    std::size_t most = 480;
    double request_s = 5.0;
    double answer_s = 15.0;
};

class Connections {
  public:
    // May wait before it answers. The bytes go out as they are.
    using Answer = std::function<std::string(const RequestBytes&, double handshake_s)>;

    Connections(OwnedSocket listening, ConnectionLimits limits, Answer answer);
    // The port is closed at once, and what is read ended. Whoever waits in `answer` has to return:
    // what it answered is written for half a second at most.
    ~Connections();
    Connections(const Connections&) = delete;
    Connections& operator=(const Connections&) = delete;

    std::size_t count() const;

  private:
    struct Place {
        Connections* room = nullptr;
        OwnedSocket socket;
        pthread_t thread{};
        bool reads = true;  // its request, still
        bool gave_way = false;
        bool is_done = false;
    };

    void run();
    void take_one();
    bool make_way();
    void start(OwnedSocket socket);
    void serve(Place& place);
    void answer(Place& place, const RequestBytes& request);
    RequestBytes read_request(int socket) const;
    void finish(Place& place);
    void join_done();
    void wake() const;

    OwnedSocket listening_;
    const ConnectionLimits limits_;
    const Answer answer_;
    OwnedSocket woken_;  // an eventfd

    mutable std::mutex mutex_;  // guards all of these
    std::condition_variable changed_;
    std::list<Place> places_;  // the oldest first
    bool ends_ = false;

    pthread_t taker_{};
    bool takes_ = false;
};

}  // namespace tact
