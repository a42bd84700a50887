#include "model/system/kept_threads.h"

#include <doctest/doctest.h>

#include <atomic>
#include <barrier>
#include <set>
#include <vector>

namespace kept_threads_test {

using namespace tact;

TEST_CASE(
    "kept threads: work is called on as many threads as are asked for, and again on the same") {
    KeptThreads kept;
    std::set<std::thread::id> seen;
    for (int round = 0; round < 20; ++round) {
        std::mutex mutex;
        std::set<std::thread::id> now;
        std::barrier all(4);  // none of the four ends before the others are there
        kept.call(3, [&] {
            all.arrive_and_wait();
            const std::lock_guard lock(mutex);
            now.insert(std::this_thread::get_id());
        });
        CHECK(now.size() == 4);
        CHECK(now.contains(std::this_thread::get_id()));
        seen.merge(now);
    }
    CHECK(seen.size() == 4);
}

TEST_CASE("kept threads: without others the work is done here") {
    KeptThreads kept;
    int calls = 0;
    kept.call(0, [&] { ++calls; });
    CHECK(calls == 1);
}

// The threads of one are busy with the others, and all come to their end nevertheless.
TEST_CASE("kept threads: work shares work, from several threads at the same time") {
    KeptThreads kept;
    std::atomic<int> inner{0};
    std::atomic<int> outer{0};
    {
        std::vector<std::jthread> askers;
        for (int k = 0; k < 4; ++k) {
            askers.emplace_back([&] {
                for (int round = 0; round < 50; ++round) {
                    kept.call(2, [&] {
                        ++outer;
                        kept.call(2, [&] { ++inner; });
                    });
                }
            });
        }
    }
    CHECK(outer >= 200);
    CHECK(outer <= 600);
    CHECK(inner >= outer);
    CHECK(inner <= 3 * outer);
}

}  // namespace kept_threads_test
