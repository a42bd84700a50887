#include "devices/phone/phone_desk.h"

#include <doctest/doctest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

namespace phone_desk_test {

using namespace tact;
using nlohmann::json;

namespace {

constexpr double kAtOnce = 0.0;
constexpr double kLong = 300.0;  // only what hangs waits so long

// A desk whose clock stands still until the test turns it.
struct Bench {
    std::atomic<double> now_s = 1000.0;
    std::atomic<int> news = 0;
    PhoneDesk desk;

    explicit Bench(std::size_t most = 400)
        : desk(
              most, [this] { ++news; }, [this] { return now_s.load(); }) {}

    std::string join(const std::string& nickname, const std::string& old = {}) {
        const PhoneReply reply = desk.join({old, nickname, true, "en"});
        return reply.status == 200 ? std::string(json::parse(reply.json).at("phone")) : "";
    }
    json next(const std::string& phone, std::int64_t card = 0, std::int64_t play = 0) {
        const PhoneReply reply = desk.next({phone, card, play}, kAtOnce);
        return reply.status == 200 ? json::parse(reply.json) : json{{"status", reply.status}};
    }
};

PhoneCards choice(const std::string& id) {
    return {R"({"kind":"choice","id":")" + id + R"(","ask":"?","options":["a","b"]})", {}};
}

}  // namespace

TEST_CASE("phone desk: who joins has a number, a name of its own, a card and nothing to play") {
    Bench bench;
    const std::string kim = bench.join("Kim");
    const std::string other = bench.join("Kim");
    CHECK(kim != other);
    CHECK(bench.news == 2);
    const auto phones = bench.desk.phones();
    REQUIRE(phones.size() == 2);
    CHECK(phones[0] == ConnectedPhone{1, "Kim", "en", true, true, PhoneSide::both, {}});
    CHECK(phones[1].nickname == "Kim 2");
    const json news = bench.next(kim);
    CHECK(news.at("card") == json{{"serial", 1}, {"kind", "wait"}});
    CHECK(news.at("play") ==
          json{{"serial", 1}, {"ms", json::array()}, {"loop", false}, {"stop", true}});
    CHECK(bench.next(kim, 1, 1) == json{{"card", {{"serial", 1}}}, {"play", {{"serial", 1}}}});
    CHECK(bench.next(std::string(22, 'x')).at("status") == 410);
}

TEST_CASE("phone desk: a card's serial rises only where its own text changed") {
    Bench bench;
    const std::string a = bench.join("A");
    const std::string b = bench.join("B");
    bench.desk.show({R"({"kind":"wait"})", {{2, R"({"kind":"thanks","text":""})"}}});
    CHECK(bench.next(a).at("card").at("serial") == 1);
    CHECK(bench.next(b).at("card") == json{{"serial", 2}, {"kind", "thanks"}, {"text", ""}});
    bench.desk.show({R"({"kind":"wait"})", {{2, R"({"kind":"thanks","text":""})"}}});
    CHECK(bench.next(b).at("card").at("serial") == 2);
    bench.desk.show({});
    CHECK(bench.next(a).at("card").at("serial") == 1);
    CHECK(bench.next(b).at("card") == json{{"serial", 3}, {"kind", "wait"}});
    bench.desk.show({" { } ", {}});  // as it may be printed
    CHECK(bench.next(a).at("card") == json{{"serial", 2}});
}

TEST_CASE("phone desk: plays go to phones of their side, and loops to those that come late") {
    Bench bench;
    const std::string both = bench.join("Both");
    const std::string a = bench.join("A");
    bench.desk.set_side(2, PhoneSide::a);
    bench.desk.play({{30, 10, 20}, true, PhoneSide::b});
    CHECK(bench.next(both).at("play") ==
          json{{"serial", 2}, {"ms", {30, 10, 20}}, {"loop", true}, {"stop", false}});
    CHECK(bench.next(a).at("play").at("stop") == true);
    const std::string late = bench.join("Late");
    CHECK(bench.next(late).at("play").at("ms") == json{30, 10, 20});
    bench.desk.set_side(2, PhoneSide::b);
    CHECK(bench.next(a).at("play").at("ms") == json{30, 10, 20});
    bench.desk.set_side(2, PhoneSide::a);
    CHECK(bench.next(a).at("play").at("stop") == true);
    bench.desk.play({});
    for (const std::string& phone : {both, a, late}) {
        CHECK(bench.next(phone).at("play").at("stop") == true);
    }
    CHECK(bench.next(bench.join("After")).at("play").at("stop") == true);
}

TEST_CASE("phone desk: of a play that ends, a late phone gets what is left, then nothing") {
    Bench bench;
    const std::string phone = bench.join("A");
    bench.desk.play({{500, 500, 500}, false, PhoneSide::both});
    bench.now_s += 0.2;  // on its way
    CHECK(bench.next(phone).at("play").at("ms") == json{500, 500, 500});
    bench.now_s += 0.4;
    CHECK(bench.next(phone).at("play").at("ms") == json{0, 400, 500});
    bench.now_s += 10.0;
    CHECK(bench.next(phone).at("play").at("stop") == true);
    const json again = bench.next(bench.join("A", phone));  // the page was loaded again
    CHECK(again.at("play").at("stop") == true);
    CHECK(again.at("play").at("serial") == 3);
}

TEST_CASE("phone desk: an answer belongs to the card that the phone has") {
    Bench bench;
    const std::string phone = bench.join("Kim");
    CHECK(bench.desk.tell({phone, "q1", R"({"option":1})", {}}).status == 409);
    bench.desk.show(choice("q1"));
    const int before = bench.news;
    CHECK(bench.desk.tell({phone, "q2", R"({"option":1})", {}}).status == 409);
    CHECK(bench.news == before);
    CHECK(bench.desk.tell({phone, "q1", R"({"option":1})", {}}).status == 204);
    CHECK(bench.news == before + 1);
    CHECK(bench.desk.take_answers() == std::vector{PhoneAnswer{1, "Kim", "q1", R"({"option":1})"}});
    CHECK(bench.desk.take_answers().empty());
    bench.desk.show(choice("q2"));
    CHECK(bench.desk.tell({phone, "q1", R"({"option":1})", {}}).status == 409);
}

TEST_CASE("phone desk: latency is half the way there and back, the median of five") {
    Bench bench;
    const std::string phone = bench.join("Kim");
    const auto latency = [&] { return bench.desk.phones()[0].latency_s; };
    CHECK_FALSE(latency());
    std::int64_t serial = 1;
    for (const double way_s : {0.04, 9.0, 0.06, 0.02, 0.08}) {
        bench.desk.play({{50}, false, PhoneSide::both});
        bench.next(phone, 1, serial++);
        bench.now_s += way_s + 0.01;
        CHECK(bench.desk.tell({phone, "", "", serial}, 0.01).status == 204);
    }
    CHECK(*latency() == doctest::Approx(0.03));
    // Told of another play, twice, or much later: that measures nothing.
    CHECK(bench.desk.tell({phone, "", "", serial}).status == 204);
    CHECK(bench.desk.tell({phone, "", "", 99}).status == 204);
    bench.desk.play({{50}, false, PhoneSide::both});
    bench.next(phone, 1, serial++);
    bench.now_s += 11.0;
    CHECK(bench.desk.tell({phone, "", "", serial}).status == 204);
    CHECK(*latency() == doctest::Approx(0.03));
}

TEST_CASE("phone desk: a phone asks 20 times a second, 40 at once, and no other one pays for it") {
    Bench bench;
    const std::string phone = bench.join("A");
    const std::string other = bench.join("B");
    for (int k = 0; k < 40; ++k) CHECK(bench.next(phone).contains("card"));
    CHECK(bench.next(phone).at("status") == 429);
    CHECK(bench.desk.tell({phone, "", "", 1}).status == 429);
    CHECK(bench.next(other).contains("card"));
    bench.now_s += 0.051;
    CHECK(bench.next(phone).contains("card"));
    CHECK(bench.next(phone).at("status") == 429);
}

TEST_CASE("phone desk: joins are bounded, and who has been gone for long gives way") {
    Bench bench(3);
    const std::string first = bench.join("A");
    bench.now_s += 1.0;
    const std::string second = bench.join("B");
    CHECK_FALSE(bench.join("C").empty());
    CHECK(bench.desk.join({"", "D", true, "en"}) == PhoneReply{503, R"({"error":"full"})"});
    CHECK_FALSE(bench.join("A", first).empty());  // one that is known comes back
    CHECK(bench.desk.phones().size() == 3);
    bench.now_s += kGoneS + 0.5;
    CHECK_FALSE(bench.desk.phones()[0].is_here);
    bench.next(second);
    CHECK_FALSE(bench.join("D").empty());
    CHECK(bench.desk.phones().size() == 3);
    CHECK(bench.next(second).contains("card"));
    int joined = 0;
    for (int k = 0; k < 1000; ++k) joined += bench.join("A", second).empty() ? 0 : 1;
    CHECK(joined <= 53);
}

TEST_CASE("phone desk: a phone that is closed hears it, and may come again as a new one") {
    Bench bench;
    const std::string phone = bench.join("A");
    bench.desk.close_phone(1);
    CHECK(bench.desk.phones().empty());
    CHECK(bench.next(phone).at("status") == 410);
    CHECK(bench.desk.tell({phone, "", "", 1}).status == 410);
    CHECK(bench.join("A", phone) != phone);
    CHECK(bench.desk.phones()[0].number == 2);
    bench.desk.close();
    CHECK(bench.desk.join({"", "B", true, "en"}).status == 410);
}

TEST_CASE("phone desk: who waits is woken by a card, a play, a close and a second poll") {
    Bench bench;
    const std::string phone = bench.join("A");
    std::atomic<bool> waiting = false;
    std::atomic<bool> has_reply = false;
    const auto woken_by = [&](const auto& change) {
        bench.now_s = bench.now_s + 10.0;  // tokens
        waiting = has_reply = false;
        const json now = bench.next(phone);
        const NextRequest same{phone, now.at("card").at("serial"), now.at("play").at("serial")};
        PhoneReply reply;
        std::thread thread([&] {
            waiting = true;
            reply = bench.desk.next(same, kLong);
            has_reply = true;
        });
        while (!waiting) std::this_thread::yield();
        change(same);
        thread.join();
        return reply.status;
    };
    const auto show = [&](const NextRequest&) { bench.desk.show(choice("q")); };
    const auto play = [&](const NextRequest&) { bench.desk.play({{20}, false, PhoneSide::both}); };
    // The earlier one of two polls is answered at once. Which one that is, is a race: further ones
    // follow until it was the thread's.
    const auto poll = [&](const NextRequest& same) {
        while (!has_reply) {
            bench.now_s = bench.now_s + 1.0;
            bench.desk.next(same, kAtOnce);
        }
    };
    CHECK(woken_by(show) == 200);
    CHECK(woken_by(play) == 200);
    CHECK(woken_by(poll) == 200);
    CHECK(woken_by([&](const NextRequest&) { bench.desk.close_phone(1); }) == 410);
}

}  // namespace phone_desk_test
