// Who means no good, or is slow: places, sizes and times are bounded, and others are served.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <thread>
#include <vector>

#include "devices/phone/phone_server.h"
#include "tests/support/comes_true.h"
#include "tests/support/page_phone.h"

namespace phone_bounds_test {

using namespace tact;
using namespace tact::raw_phone;
using Clock = std::chrono::steady_clock;

namespace {

std::unique_ptr<PhoneServer> served(double request_s) {
    PhoneServerSettings settings;
    settings.host = "127.0.0.1";
    settings.page = {{"index.html", "text/html", std::string(50'000, 'x')}};
    settings.request_s = request_s;
    settings.answer_s = request_s;
    settings.poll_s = 120.0;
    auto server = PhoneServer::open(std::move(settings));
    REQUIRE(server);
    return *std::move(server);
}

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::size_t thread_count() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

// A poll that has reached its desk: of two, the later one to come ends the other.
Connection waiting_poll(const Phone& phone) {
    Connection one(phone.place.port);
    Connection other(phone.place.port);
    one.send(phone.next_text());
    other.send(phone.next_text());
    CHECK(comes_true([&] { return one.has_news() || other.has_news(); }));
    return one.has_news() ? std::move(other) : std::move(one);
}

}  // namespace

TEST_CASE("phone bounds: what is too large, malformed or deep is refused, and said") {
    const auto server = served(5.0);
    const Place place(server->address());
    const std::string join = "POST " + place.path + "join HTTP/1.1\r\n";
    const std::string large(4097, 'x');
    CHECK(sent(place, join + "Content-Length: 4097\r\n\r\n" + large).status == 413);
    CHECK(sent(place, join + "Content-Length: 1000000000\r\n\r\n" + large).status == 413);
    CHECK(sent(place, join + "Transfer-Encoding: chunked\r\n\r\n1001\r\n" + large).status == 411);
    CHECK(sent(place, join + "Content-Length: 2\r\n\r\n{}" + large).status == 200);  // not read
    CHECK(asked(place, "POST", "join", "{").status == 400);
    CHECK(asked(place, "POST", "join", std::string(4096, '[')).status == 400);
    CHECK(asked(place, "POST", "join").status == 400);
    CHECK(asked(place, "POST", "next", "{}").status == 400);
    CHECK(asked(place, "POST", "tell", "{}").status == 400);
    CHECK(sent(place, "\x16\x03\x01\x02\r\n\r\n").status == 400);  // TLS
    CHECK(sent(place, "\r\n\r\n").status == 400);
    CHECK(sent(place, "GET / HTTP/9.9\r\n\r\n").status == 400);
    std::string many = "GET / HTTP/1.1\r\n";
    for (int k = 0; k < 100; ++k) many += "Header" + std::to_string(k) + ": x\r\n";
    CHECK(sent(place, many + "\r\n").status == 431);
    CHECK(sent(place, "GET /" + std::string(20'000, 'x') + " HTTP/1.1\r\n\r\n").status == 431);
    CHECK(sent(place, join + "Content-Type: multipart/form-data; boundary=x\r\n"
                             "Content-Length: 2\r\n\r\n{}")
              .status == 200);  // as any text
    CHECK(server->phones().size() == 2);
}

TEST_CASE("phone bounds: half-open and dripping connections end, while phones are served" *
          doctest::test_suite("long")) {
    constexpr double kRequestS = 0.4;
    const auto server = served(kRequestS);
    const Place place(server->address());
    const auto begin = Clock::now();
    std::vector<Connection> half_open;
    std::vector<Connection> dripping;
    for (int k = 0; k < 100; ++k) {
        half_open.emplace_back(place.port);
        if (k % 2 == 0) half_open.back().send("POST " + place.path + "join HTTP/1.1\r\nA: ");
    }
    for (int k = 0; k < 20; ++k) {
        dripping.emplace_back(place.port);
        dripping.back().send("GET / HTTP/1.1\r\nA: ");
    }
    std::vector<std::jthread> drips;
    drips.emplace_back([&](const std::stop_token& quit) {
        while (!quit.stop_requested()) {
            for (const Connection& each : dripping) each.send("x");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    });
    for (int k = 0; k < 20; ++k) {
        Phone phone{place};
        CHECK(phone.join("Kim").status == 200);
        CHECK_FALSE(phone.next().empty());
    }
    const auto all_closed = [](const std::vector<Connection>& all) {
        return std::ranges::all_of(all, &Connection::has_news);
    };
    CHECK(comes_true([&] { return all_closed(half_open) && all_closed(dripping); }));
    CHECK(since(begin) >= kRequestS);
    drips.clear();
    CHECK(half_open[0].reply().status == 408);
    CHECK(half_open[1].reply().status == 0);  // that said nothing hears nothing
}

TEST_CASE("phone bounds: who takes no answer loses its place" * doctest::test_suite("long")) {
    PhoneServerSettings settings;
    settings.host = "127.0.0.1";
    settings.page = {{"index.html", "text/html", std::string(16'000'000, 'x')}};
    settings.answer_s = 0.3;
    const auto server = PhoneServer::open(std::move(settings));
    REQUIRE(server);
    const Place place((*server)->address());
    const std::size_t threads = thread_count();
    std::vector<Connection> slow;
    for (int k = 0; k < 3; ++k) {
        slow.emplace_back(place.port);
        slow.back().send(request_text("GET", place.path));
    }
    CHECK(comes_true([&] { return std::ranges::all_of(slow, &Connection::has_news); }));
    CHECK(comes_true([&] { return thread_count() <= threads; }));
    CHECK(slow[0].all().size() < 16'000'000);
}

TEST_CASE("phone bounds: a phone that asks too often is told so") {
    const auto server = served(5.0);
    Phone phone{Place(server->address())};
    Phone other{phone.place};
    phone.join("A");
    other.join("B");
    const auto asks_too_often = [&] {
        phone.card = phone.play = 0;
        return sent(phone.place, phone.next_text()).status == 429;
    };
    CHECK(comes_true(asks_too_often));
    CHECK_FALSE(other.next().empty());
}

TEST_CASE("phone bounds: the server ends within a second while 50 phones wait and others drip") {
    auto server = served(120.0);
    const Place place(server->address());
    std::vector<Connection> waiting;
    for (int k = 0; k < 50; ++k) {
        Phone phone{place};
        phone.join("Kim");
        phone.next();
        waiting.push_back(waiting_poll(phone));
    }
    std::vector<Connection> half_open;
    for (int k = 0; k < 20; ++k) {
        half_open.emplace_back(place.port);
        half_open.back().send("GET /");
    }
    const std::size_t threads = thread_count();
    const auto begin = Clock::now();
    server.reset();
    const double took_s = since(begin);
    MESSAGE("the end took " << 1e3 * took_s << " ms");
    CHECK(took_s < 1.0);
    for (const Connection& each : waiting) CHECK(each.reply().status == 410);
    CHECK(comes_true([&] { return thread_count() < threads; }));
    CHECK_FALSE(Connection(place.port).is_open());
}

}  // namespace phone_bounds_test
