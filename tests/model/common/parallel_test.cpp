#include "model/common/parallel.h"

#include <atomic>

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

}  // namespace parallel_test
