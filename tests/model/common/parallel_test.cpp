#include "model/common/parallel.h"

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/support/golden.h"

namespace parallel_test {

using namespace tact;

TEST_CASE("parallel: every index is worked on exactly once, for any number of threads") {
    for (const int threads : {0, 1, 2, 4, 33}) {
        std::vector<std::atomic<int>> visits(1000);
        CHECK(parallel_for(visits.size(), threads, {}, [&](std::size_t k) { ++visits[k]; }));
        CHECK(std::ranges::all_of(visits, [](const auto& count) { return count == 1; }));
    }
    CHECK(parallel_for(0, 2, {}, [](std::size_t) {}));
}

TEST_CASE("parallel: a stop leaves the rest undone and says so") {
    std::stop_source stop;
    std::atomic<int> done{0};
    const bool finished = parallel_for(1000, 2, stop.get_token(), [&](std::size_t) {
        if (++done == 10) stop.request_stop();
    });
    CHECK_FALSE(finished);
    CHECK(done < 1000);
}

TEST_CASE("parallel: what the work throws reaches the caller, that of the lowest index") {
    for (const int threads : {1, 2, 4, 33}) {
        CAPTURE(threads);
        std::string message;
        try {
            parallel_for(1000, threads, {}, [](std::size_t k) {
                // The first to fail takes longest.
                if (k == 500) std::this_thread::sleep_for(std::chrono::milliseconds(5));
                if (k >= 500) throw std::runtime_error("at " + std::to_string(k));
            });
        } catch (const std::runtime_error& thrown) {
            message = thrown.what();
        }
        CHECK(message == "at 500");
    }
}

TEST_CASE("parallel: after an exception no more work is begun") {
    std::atomic<int> begun{0};
    CHECK_THROWS_AS(parallel_for(1'000'000, 2, {},
                                 [&](std::size_t k) {
                                     ++begun;
                                     if (k == 3) throw std::bad_alloc();
                                 }),
                    std::bad_alloc);
    CHECK(begun < 1'000'000);
}

}  // namespace parallel_test
