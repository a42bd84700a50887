#include "app/jobs/jobs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace turns_test {

using namespace tact;

namespace {

struct NoThreads {
    NoThreads() { pretend_no_threads(true); }
    ~NoThreads() { pretend_no_threads(false); }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;
};

}  // namespace

TEST_CASE("turns: those who asked get one each, in their order; some only at rest") {
    std::string order;
    TurnTaker preview(TurnKind::soon, [&] { order += "p"; });
    TurnTaker exact(TurnKind::at_rest, [&] { order += "e"; });
    CHECK_FALSE(give_turn(true));
    exact.ask();
    preview.ask();
    preview.ask();
    CHECK(give_turn(false));
    CHECK_FALSE(give_turn(false));
    CHECK(give_turn(true));
    CHECK_FALSE(give_turn(true));
    CHECK(order == "pe");
    CHECK_FALSE(is_turn_over());
    {
        TurnTaker gone(TurnKind::soon, [&] { order += "g"; });
        gone.ask();
    }
    CHECK_FALSE(give_turn(true));
}

TEST_CASE("turns: a job without a thread answers the newest request, once it has a turn") {
    const NoThreads pretended;
    int woken = 0;
    LatestJob<int, int> job(
        JobPolicy::supersede,
        [](const int& request, std::stop_token, std::atomic<float>&) {
            return std::optional(2 * request);
        },
        [&] { ++woken; });
    job.submit(1);
    job.submit(2);
    CHECK(job.busy());
    CHECK_FALSE(give_turn(false));
    CHECK(give_turn(true));
    CHECK_FALSE(job.busy());
    REQUIRE(job.latest());
    CHECK(*job.latest() == 4);
    CHECK(woken == 1);
    job.submit(3);
    job.cancel();
    CHECK_FALSE(job.busy());
    give_turn(true);
    CHECK(*job.latest() == 4);
}

// What happens while work pauses happens within it here.
TEST_CASE("turns: while work pauses, others get theirs") {
    const NoThreads pretended;
    std::string order;
    TurnTaker preview(TurnKind::soon, [&] { order += "p"; });
    TurnTaker exact(TurnKind::at_rest, [&] { order += "e"; });
    TurnTaker training(TurnKind::at_rest, [&] {
        order += "t";
        exact.ask();
        preview.ask();
        CHECK(give_turn(false));
        CHECK_FALSE(give_turn(false));
        CHECK(give_turn(true));
        order += "t";
    });
    training.ask();
    CHECK(give_turn(true));
    CHECK_FALSE(give_turn(true));
    CHECK(order == "tpet");
}

TEST_CASE("turns: what a job is asked while its work pauses comes after it") {
    const NoThreads pretended;
    std::vector<int> seen;
    std::optional<LatestJob<int, int>> job;
    job.emplace(JobPolicy::supersede,
                [&](const int& request, std::stop_token stop, std::atomic<float>&) {
                    seen.push_back(request);
                    if (request == 1) {
                        job->submit(2);
                        CHECK(stop.stop_requested());
                        CHECK(give_turn(true));
                        CHECK(seen == std::vector{1});
                    }
                    return std::optional(request);
                });
    job->submit(1);
    CHECK(give_turn(true));
    CHECK(job->busy());
    CHECK(give_turn(true));
    CHECK_FALSE(give_turn(true));
    CHECK(seen == std::vector{1, 2});
    REQUIRE(job->latest());
    CHECK(*job->latest() == 2);
}

TEST_CASE("turns: a job may go while its work pauses, which is stopped then and ends later") {
    const NoThreads pretended;
    bool is_stopped = false;
    int woken = 0;
    std::unique_ptr<LatestJob<int, int>> job;
    job = std::make_unique<LatestJob<int, int>>(
        JobPolicy::supersede,
        [&](const int& request, std::stop_token stop, std::atomic<float>& progress) {
            job.reset();
            progress = 0.5F;
            is_stopped = stop.stop_requested();
            want_another_turn();
            return std::optional(request);
        },
        [&] { ++woken; });
    job->submit(1);
    CHECK(give_turn(true));
    CHECK(is_stopped);
    CHECK(woken == 1);
    CHECK_FALSE(give_turn(true));
}

TEST_CASE("turns: work that gives its turn back continues, unless something else is wanted") {
    const NoThreads pretended;
    std::vector<int> seen;
    int missing = 2;
    LatestJob<int, int> job(JobPolicy::finish,
                            [&](const int& request, std::stop_token, std::atomic<float>& progress) {
                                seen.push_back(request);
                                progress = progress + 0.25F;
                                if (missing == 0) return std::optional(request);
                                --missing;
                                want_another_turn();
                                return std::optional<int>();
                            });
    job.submit(7);
    CHECK(give_turn(false));
    CHECK(job.busy());
    CHECK(job.progress() == 0.25F);
    CHECK(give_turn(false));
    CHECK(job.progress() == 0.5F);  // of the same request it is not told from its beginning
    CHECK(give_turn(false));
    CHECK_FALSE(job.busy());
    CHECK(*job.latest() == 7);
    missing = 1;
    job.submit(8);
    CHECK(give_turn(false));
    job.submit(9);
    CHECK(give_turn(false));
    CHECK_FALSE(give_turn(false));
    CHECK(*job.latest() == 9);
    CHECK(seen == std::vector{7, 7, 7, 8, 9});
    missing = 1;
    job.submit(10);
    CHECK(give_turn(false));
    job.cancel();
    CHECK_FALSE(job.busy());
    give_turn(false);
    CHECK(*job.latest() == 9);
}

}  // namespace turns_test
