#include "devices/phone/phone_server.h"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "devices/phone/phone_device.h"
#include "tests/support/page_phone.h"
#include "tests/support/patience.h"

namespace phone_server_test {

using namespace tact;
using namespace tact::raw_phone;
using nlohmann::json;

namespace {

std::vector<PageFile> page() {
    return {{"index.html", "text/html; charset=utf-8", "<!doctype html><title>x</title>"},
            {"phone.js", "text/javascript", "'use strict';"},
            {"texts.json", "application/json", "{}"}};
}

std::unique_ptr<PhoneServer> served(double poll_s = 20.0, std::function<void()> news = {}) {
    PhoneServerSettings settings;
    settings.host = "127.0.0.1";
    settings.page = page();
    settings.poll_s = poll_s;
    auto server = PhoneServer::open(std::move(settings), std::move(news));
    REQUIRE(server);
    return *std::move(server);
}

}  // namespace

TEST_CASE("phone server: the address has a token of its own, and the page below it") {
    const auto server = served();
    const Place place(server->address());
    CHECK(place.path.size() == 24);
    CHECK(Place(served()->address()).path != place.path);
    const Reply index = asked(place, "GET", "");
    CHECK(index.status == 200);
    CHECK(index.body == page()[0].text);
    CHECK(index.head.find("Content-Type: text/html; charset=utf-8\r\n") != std::string::npos);
    CHECK(asked(place, "GET", "phone.js").body == "'use strict';");
    CHECK(asked(place, "GET", "phone.js?v=1").body == "'use strict';");
    CHECK(asked(place, "GET", "texts.json").body == "{}");
}

TEST_CASE("phone server: every answer says what the page may do, and nothing of who serves it") {
    const auto server = served();
    const Place place(server->address());
    for (const Reply& reply :
         {asked(place, "GET", ""), asked(place, "GET", "none"), asked(place, "POST", "join", "{}"),
          sent(place, "?\r\n\r\n"), sent(place, "GET / HTTP/1.1\r\nRange: bytes=0-\r\n\r\n")}) {
        for (const char* header :
             {"Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
              "connect-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'; "
              "frame-ancestors 'none'\r\n",
              "X-Content-Type-Options: nosniff\r\n", "Referrer-Policy: no-referrer\r\n",
              "Cache-Control: no-store\r\n", "Cross-Origin-Resource-Policy: same-origin\r\n",
              "Connection: close\r\n"}) {
            CAPTURE(header);
            CHECK(reply.head.find(header) != std::string::npos);
        }
        for (const char* none : {"Server:", "Access-Control", "httplib", "EXCEPTION"}) {
            CHECK(reply.head.find(none) == std::string::npos);
        }
    }
}

TEST_CASE("phone server: a wrong token, a wrong route and a wrong method have the same answer") {
    const auto server = served();
    const Place place(server->address());
    const auto bytes = [&](const std::string& method, const std::string& path) {
        const Connection connection(place.port);
        connection.send(request_text(method, path));
        return connection.all();
    };
    const std::string none = bytes("GET", place.path + "nothing");
    CHECK(reply_of(none).status == 404);
    CHECK(reply_of(none).body.empty());
    std::string other = place.path;
    other[5] = other[5] == 'A' ? 'B' : 'A';
    for (const std::string& path :
         {std::string("/"), std::string("/favicon.ico"), other, other + "phone.js",
          place.path + "/", place.path.substr(0, 23), place.path + "index.html",
          place.path + "phone.js/", "/" + place.path + "phone.js", place.path + "PHONE.JS",
          place.path + "phone.js%00"}) {
        CAPTURE(path);
        CHECK(bytes("GET", path) == none);
    }
    for (const std::string name : {"join", "next", "tell"}) {
        CHECK(bytes("GET", place.path + name) == none);
        CHECK(bytes("POST", other + name) == none);
    }
    for (const char* method : {"PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"}) {
        CHECK(bytes(method, place.path) == none);
    }
    CHECK(reply_of(bytes("HEAD", place.path)).status == 404);
    CHECK(reply_of(bytes("BREW", place.path)).status == 400);
}

TEST_CASE("phone server: no path leads to the disk") {
    const auto server = served();
    const Place place(server->address());
    for (const std::string path :
         {"../../../../etc/passwd", "..%2f..%2f..%2fetc%2fpasswd", "%2e%2e/%2e%2e/etc/passwd",
          "....//....//etc/passwd", "..\\..\\etc\\passwd", "%252e%252e%252fetc%252fpasswd",
          "/etc/passwd", "file:///etc/passwd", "phone.js/../../etc/passwd",
          "%u002e%u002e/etc/passwd", "%", "%f", "%zz", "%u", "%uD800"}) {
        CAPTURE(path);
        const Reply reply = asked(place, "GET", path);
        CHECK(reply.status == 404);
        CHECK(reply.body.empty());
        CHECK(sent(place, request_text("GET", "/" + path)).status == 404);
    }
}

TEST_CASE("phone server: a phone joins, waits, and gets cards and plays as they change") {
    std::atomic<int> news = 0;
    const auto server = served(120.0, [&] { ++news; });
    Phone phone{Place(server->address())};
    CHECK(phone.join("Kim").status == 200);
    CHECK(news == 1);
    CHECK(phone.next().at("card").at("kind") == "wait");
    const Connection waits(phone.place.port);
    waits.send(phone.next_text());
    server->show({R"({"kind":"choice","id":"q1","ask":"?","options":["a","b"]})", {}});
    const json card = phone.news_of(waits.reply());
    CHECK(card.at("card").at("id") == "q1");
    CHECK_FALSE(card.at("play").contains("ms"));
    CHECK(phone.tell({{"card", "q1"}, {"answer", {{"option", 1}}}}) == 204);
    CHECK(server->take_answers() == std::vector{PhoneAnswer{1, "Kim", "q1", R"({"option":1})"}});
    CHECK(phone.tell({{"card", "q0"}, {"answer", {{"option", 1}}}}) == 409);
    const Connection waits_again(phone.place.port);
    waits_again.send(phone.next_text());
    server->play({{50, 20, 50}, false, PhoneSide::both});
    CHECK(phone.news_of(waits_again.reply()).at("play").at("ms") == json{50, 20, 50});
    CHECK(phone.tell({{"played", phone.play}}) == 204);
    const auto latency_s = server->phones().at(0).latency_s;
    REQUIRE(latency_s);
    CHECK(*latency_s < 60.0);
    MESSAGE("latency over loopback: " << 1e3 * *latency_s << " ms");
}

TEST_CASE("phone server: each phone has its own card, and a poll ends without news, too") {
    const auto server = served(0.0);
    Phone a{Place(server->address())};
    Phone b{Place(server->address())};
    a.join("A");
    b.join("B");
    server->show({R"({"kind":"wait"})", {{b.number, R"({"kind":"thanks","text":"b"})"}}});
    CHECK(a.next().at("card").at("kind") == "wait");
    CHECK(b.next().at("card").at("text") == "b");
    CHECK(b.next() == json{{"card", {{"serial", b.card}}}, {"play", {{"serial", b.play}}}});
    server->set_side(b.number, PhoneSide::b);
    server->play({{30}, true, PhoneSide::a});
    CHECK_FALSE(b.next().at("play").contains("ms"));
    CHECK(a.next().at("play").at("ms") == json{30});
}

TEST_CASE("phone server: a phone that is sent away hears it while it waits") {
    const auto server = served(120.0);
    Phone phone{Place(server->address())};
    phone.join("Kim");
    phone.next();
    const Connection waits(phone.place.port);
    waits.send(phone.next_text());
    server->close_phone(phone.number);
    CHECK(waits.reply().status == 410);
    CHECK(sent(phone.place, phone.next_text()).status == 410);
    CHECK(server->phones().empty());
}

TEST_CASE("phone server: a device plays on the phones that are there") {
    const std::shared_ptr<PhoneServer> server = served(120.0);
    PhoneDevice device(server);
    CHECK_FALSE(device.status().connected);
    Phone phone{Place(server->address())};
    phone.join("Kim");
    phone.next();
    CHECK(device.status().connected);
    Drive drive;
    drive.samples.assign(1000, 1.0);
    REQUIRE(device.play(drive, true));
    CHECK(phone.next().at("play").at("loop") == true);
    device.stop();
    CHECK(phone.next().at("play").at("stop") == true);
}

TEST_CASE("phone server: what cannot be listened on is said, and a pipe ends others as before") {
    PhoneServerSettings settings;
    settings.host = "192.0.2.1";  // RFC 5737: of no computer
    CHECK_FALSE(PhoneServer::open(settings));
    settings.host = "not an address";
    CHECK_FALSE(PhoneServer::open(settings));
    const auto server = served();
    settings.host = "127.0.0.1";
    settings.port = Place(server->address()).port;
    const auto second = PhoneServer::open(settings);
    REQUIRE_FALSE(second);
    CHECK(second.error().message.find("127.0.0.1, port " + std::to_string(settings.port)) !=
          std::string::npos);
    struct sigaction now {};
    sigaction(SIGPIPE, nullptr, &now);
    const bool is_as_before = now.sa_handler == SIG_DFL;
    CHECK(is_as_before);
}

}  // namespace phone_server_test
