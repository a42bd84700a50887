#include "devices/http/connections.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "tests/support/comes_true.h"
#include "tests/support/raw_phone.h"

namespace connections_test {

using namespace tact;
using namespace tact::raw_phone;

namespace {

// Answers that wait until they may go.
struct Door {
    std::atomic<int> waiting = 0;
    std::atomic<bool> is_open = false;
    int port = 0;
    std::unique_ptr<Connections> connections;

    explicit Door(const ConnectionLimits& limits) {
        auto listening = listening_socket("127.0.0.1", 0);
        REQUIRE(listening);
        port = port_of(*listening);
        connections = std::make_unique<Connections>(
            *std::move(listening), limits, [this](const RequestBytes& request, double) {
                ++waiting;
                is_open.wait(false);
                return "HTTP/1.1 200 OK\r\n\r\n" + std::string(request.body());
            });
    }
    ~Door() { open(); }
    void open() {
        is_open = true;
        is_open.notify_all();
    }
};

const std::string kRequest = "POST / HTTP/1.1\r\nContent-Length: 2\r\n\r\nhi";

}  // namespace

TEST_CASE("connections: where all places are taken, who sends no request gives way") {
    Door door({8, 120.0, 120.0});
    std::vector<Connection> half_open;
    for (int k = 0; k < 40; ++k) {
        half_open.emplace_back(door.port);
        half_open.back().send("GET /");
    }
    std::vector<Connection> waiting;
    for (int k = 0; k < 8; ++k) {
        waiting.emplace_back(door.port);
        waiting.back().send(kRequest);
        CHECK(comes_true([&] { return door.waiting == k + 1; }));
    }
    CHECK(comes_true([&] { return std::ranges::all_of(half_open, &Connection::has_news); }));
    CHECK(comes_true([&] { return door.connections->count() == 8; }));
    // Who waits for an answer is not pushed out: the one that is new is closed at once.
    const Connection refused(door.port);
    refused.send(kRequest);
    CHECK(refused.reply().status == 0);
    CHECK(std::ranges::none_of(waiting, &Connection::has_news));
    door.open();
    for (const Connection& each : waiting) CHECK(each.reply().body == "hi");
    CHECK(comes_true([&] { return door.connections->count() == 0; }));
    const Connection later(door.port);
    later.send(kRequest);
    CHECK(later.reply().body == "hi");
}

TEST_CASE("connections: a request that is cut by its sender ends, and one whole is answered") {
    Door door({8, 120.0, 120.0});
    door.open();
    const Connection cut(door.port);
    cut.send("POST / HTTP/1.1\r\nContent-Length: 20\r\n\r\nhi");
    shutdown(cut.socket(), SHUT_WR);
    CHECK(cut.reply().status == 200);  // the door answers whatever it is asked, refused or not
    const Connection whole(door.port);
    for (const char sign : kRequest) whole.send(std::string_view(&sign, 1));
    CHECK(whole.reply().body == "hi");
    { const Connection none(door.port); }
    CHECK(comes_true([&] { return door.connections->count() == 0; }));
    CHECK(door.waiting == 2);
}

}  // namespace connections_test
