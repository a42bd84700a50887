// A question that a room asks in each frame: asked once, answered once, and left when nobody wants
// to know any more.
#include "app/jobs/query.h"

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

struct Asked {
    Square query;
    std::atomic<int> runs = 0;

    void begin() {
        query.begin(JobPolicy::supersede, [this](int number, std::stop_token, std::atomic<float>&) {
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

TEST_CASE("query: before it begins nothing is asked, and that is no fault") {
    Square query;
    query.want(3);
    query.ask(4);
    query.cancel();
    query.leave();
    query.forget();
    CHECK_FALSE(query.has_begun());
    CHECK_FALSE(query.busy());
    CHECK_FALSE(query.asked());
    CHECK(query.latest() == nullptr);
    CHECK(query.current() == nullptr);
    CHECK(query.failure().empty());
}

TEST_CASE("query: what is wanted in every frame is asked once") {
    Asked asked;
    asked.begin();
    for (int frame = 0; frame < 5; ++frame) asked.query.want(3);
    asked.rest();
    for (int frame = 0; frame < 5; ++frame) asked.query.want(3);
    asked.rest();
    CHECK(asked.runs == 1);
    REQUIRE(asked.query.current());
    CHECK(asked.query.current()->square == 9);
    asked.query.want(4);
    if (const auto current = asked.query.current()) CHECK(current->square == 16);
    asked.rest();
    CHECK(asked.query.current()->square == 16);
    CHECK(asked.runs == 2);
}

TEST_CASE("query: an answer to what nobody asks any more is no current one") {
    Asked asked;
    asked.begin();
    asked.query.want(3);
    asked.rest();
    asked.query.want(std::nullopt);
    CHECK_FALSE(asked.query.asked());
    CHECK(asked.query.current() == nullptr);
    CHECK(asked.query.latest()->square == 9);
    asked.query.want(3);
    asked.rest();
    CHECK(asked.runs == 2);
}

TEST_CASE("query: what was cancelled is asked again only when something else was wanted") {
    Asked asked;
    std::atomic<bool> goes_on = false;
    asked.query.begin(
        JobPolicy::supersede,
        [&](int number, const std::stop_token& stop, std::atomic<float>&) -> std::optional<Answer> {
            ++asked.runs;
            while (!goes_on && !stop.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            if (stop.stop_requested()) return std::nullopt;
            return Answer{number, number * number};
        });
    asked.query.want(3);
    asked.query.cancel();
    asked.rest();
    const int runs = asked.runs;
    asked.query.want(3);
    CHECK_FALSE(asked.query.busy());
    CHECK(asked.runs == runs);
    goes_on = true;
    asked.query.want(4);
    asked.rest();
    CHECK(asked.query.current()->square == 16);
}

TEST_CASE(
    "query: a copy has no work; a query that another is assigned to keeps its work and forgets") {
    Asked asked;
    asked.begin();
    asked.query.want(3);
    asked.rest();
    const Square copy = asked.query;
    CHECK_FALSE(copy.has_begun());
    CHECK(copy.latest() == nullptr);
    const Square fresh;
    asked.query = fresh;
    CHECK(asked.query.has_begun());
    CHECK_FALSE(asked.query.asked());
    CHECK(asked.query.latest() == nullptr);
    asked.query.want(3);
    asked.rest();
    CHECK(asked.query.current()->square == 9);
    asked.query.end();
    CHECK_FALSE(asked.query.has_begun());
    CHECK_FALSE(asked.query.asked());
}

}  // namespace query_test
