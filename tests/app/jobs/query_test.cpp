// A question that a room asks in each frame: asked once, answered once, and left when nobody wants
// to know any more.
#include "app/jobs/jobs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/support/patience.h"

namespace query_test {

using namespace tact;

namespace {

struct Answer {
    int request = 0;
    int square = 0;
};

using Square = Query<int, Answer>;

std::optional<Answer> negative(int number, const std::stop_token&, std::atomic<float>&) {
    return Answer{number, -number * number};
}

struct Asked {
    std::atomic<int> runs = 0;
    Square query;

    void want(std::optional<int> request) {
        query.want(request, [this](int number, std::stop_token, std::atomic<float>&) {
            ++runs;
            return std::optional(Answer{number, number * number});
        });
    }
    void rest() const {
        const auto until = end_of_patience();
        while (query.busy()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
};

}  // namespace

TEST_CASE("query: before the first question there is no work, and that is no fault") {
    Asked asked;
    Square& query = asked.query;
    asked.want(std::nullopt);
    query.cancel();
    query.leave();
    query.forget();
    CHECK_FALSE(query.busy());
    CHECK_FALSE(query.asked());
    CHECK(query.latest() == nullptr);
    CHECK(query.current() == nullptr);
    CHECK(query.failure().empty());
}

TEST_CASE("query: what is wanted in every frame is asked once") {
    Asked asked;
    for (int frame = 0; frame < 5; ++frame) asked.want(3);
    asked.rest();
    for (int frame = 0; frame < 5; ++frame) asked.want(3);
    asked.rest();
    CHECK(asked.runs == 1);
    REQUIRE(asked.query.current());
    CHECK(asked.query.current()->square == 9);
    asked.want(4);
    if (const auto current = asked.query.current()) CHECK(current->square == 16);
    asked.rest();
    CHECK(asked.query.current()->square == 16);
    CHECK(asked.runs == 2);
}

TEST_CASE("query: an answer to what nobody asks any more is no current one") {
    Asked asked;
    asked.want(3);
    asked.rest();
    asked.want(std::nullopt);
    CHECK_FALSE(asked.query.asked());
    CHECK(asked.query.current() == nullptr);
    CHECK(asked.query.latest()->square == 9);
    asked.want(3);
    asked.rest();
    CHECK(asked.runs == 2);
}

TEST_CASE("query: what was cancelled is asked again only when something else was wanted") {
    std::atomic<bool> goes_on = false;
    Asked asked;
    asked.query.begin(
        [&](int number, const std::stop_token& stop, std::atomic<float>&) -> std::optional<Answer> {
            ++asked.runs;
            while (!goes_on && !stop.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            if (stop.stop_requested()) return std::nullopt;
            return Answer{number, number * number};
        });
    asked.want(3);
    asked.query.cancel();
    asked.rest();
    const int runs = asked.runs;
    asked.want(3);
    CHECK_FALSE(asked.query.busy());
    CHECK(asked.runs == runs);
    goes_on = true;
    asked.want(4);
    asked.rest();
    CHECK(asked.query.current()->square == 16);
}

TEST_CASE(
    "query: a copy has no work; a query that another is assigned to keeps its work and forgets") {
    Asked asked;
    asked.want(3);
    asked.rest();
    const Square copy = asked.query;
    CHECK_FALSE(copy.asked());
    CHECK(copy.latest() == nullptr);
    const Square fresh;
    asked.query = fresh;
    CHECK_FALSE(asked.query.asked());
    CHECK(asked.query.latest() == nullptr);
    asked.query.ask(3, negative);
    asked.rest();
    CHECK(asked.query.current()->square == 9);
    asked.query = Square();  // moved from: the work ends
    asked.query.ask(3, negative);
    asked.rest();
    CHECK(asked.query.current()->square == -9);
}

TEST_CASE("query: its destructor stops the work, whatever waits behind it") {
    std::atomic<bool> is_begun = false;
    std::atomic<bool> was_stopped = false;
    std::atomic<int> runs = 0;
    const auto until_stopped = [&](int, const std::stop_token& stop,
                                   std::atomic<float>&) -> std::optional<Answer> {
        ++runs;
        is_begun = true;
        while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        was_stopped = true;
        return std::nullopt;
    };
    {
        Square query;
        query.ask(1, until_stopped, {}, JobPolicy::finish);
        while (!is_begun) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        query.ask(2, until_stopped);
    }
    CHECK(was_stopped);
    CHECK(runs == 1);
}

}  // namespace query_test
