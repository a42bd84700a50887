#include "app/jobs/jobs.h"

#include <doctest/doctest.h>

#include <chrono>
#include <new>
#include <semaphore>
#include <vector>

namespace latest_job_test {

using namespace tact;
using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;
using Job = LatestJob<int, int>;

// Ten seconds: only a hang takes that long, even under sanitizers on a busy machine.
template <class Condition>
bool eventually(Condition condition) {
    const auto deadline = Clock::now() + 10s;
    while (!condition()) {
        if (Clock::now() > deadline) return false;
        std::this_thread::sleep_for(200us);
    }
    return true;
}

std::optional<int> doubled(const int& request, std::stop_token, std::atomic<float>&) {
    return 2 * request;
}

// Runs until it is told to stop; counts itself in `started`.
struct Endless {
    std::atomic<int>* started;

    std::optional<int> operator()(const int& request, std::stop_token stop,
                                  std::atomic<float>& progress) const {
        ++*started;
        progress = 0.5F;
        while (request < 0 && !stop.stop_requested()) std::this_thread::sleep_for(100us);
        return request;
    }
};

}  // namespace

TEST_CASE("job: of a thousand requests in a row the last is always answered") {
    for (const JobPolicy policy : {JobPolicy::finish, JobPolicy::supersede}) {
        std::atomic<int> runs = 0;
        Job job(policy, [&](const int& request, std::stop_token, std::atomic<float>&) {
            ++runs;
            return std::optional(2 * request);
        });
        CHECK(job.latest() == nullptr);
        for (int i = 1; i <= 1000; ++i) job.submit(i);
        REQUIRE(eventually([&] { return !job.busy(); }));
        REQUIRE(job.latest() != nullptr);
        CHECK(*job.latest() == 2000);
        CHECK(runs <= 1000);
    }
}

TEST_CASE("job: a preview finishes although newer requests come, and then takes the newest") {
    std::counting_semaphore<> may_end(0);
    std::atomic<int> started = 0;
    Job job(JobPolicy::finish, [&](const int& request, std::stop_token stop, std::atomic<float>&) {
        ++started;
        may_end.acquire();
        CHECK_FALSE(stop.stop_requested());
        return std::optional(request);
    });
    job.submit(1);
    REQUIRE(eventually([&] { return started == 1; }));
    job.submit(2);
    job.submit(3);
    may_end.release();
    REQUIRE(eventually([&] { return started == 2; }));
    REQUIRE(job.latest() != nullptr);
    CHECK(*job.latest() == 1);
    may_end.release();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(*job.latest() == 3);
    CHECK(started == 2);
}

TEST_CASE("job: a full run is stopped by a newer request within milliseconds") {
    std::atomic<int> started = 0;
    Job job(JobPolicy::supersede, Endless{&started});
    job.submit(-1);
    REQUIRE(eventually([&] { return started == 1; }));
    const auto begin = Clock::now();
    job.submit(7);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    // The work polls every 0.1 ms; the rest is for a machine with other things to do.
    CHECK(Clock::now() - begin < 200ms);
    CHECK(*job.latest() == 7);  // and -1, stopped, was never published
}

TEST_CASE("job: a newer request for the same work waits for the running one, any other stops it") {
    std::counting_semaphore<> may_end(0);
    std::atomic<int> started = 0;
    std::atomic<int> stopped = 0;
    Job job(
        JobPolicy::supersede,
        [&](const int& request, std::stop_token stop, std::atomic<float>&) {
            ++started;
            while (!may_end.try_acquire_for(100us) && !stop.stop_requested()) continue;
            if (stop.stop_requested()) ++stopped;
            return std::optional(request);
        },
        {}, [](const int& running, const int& newer) { return running / 10 == newer / 10; });
    job.submit(11);
    REQUIRE(eventually([&] { return started == 1; }));
    job.submit(12);
    may_end.release();
    REQUIRE(eventually([&] { return started == 2; }));
    CHECK(stopped == 0);
    REQUIRE(job.latest() != nullptr);
    CHECK(*job.latest() == 11);
    job.submit(21);
    REQUIRE(eventually([&] { return started == 3; }));
    CHECK(stopped == 1);
    may_end.release();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(*job.latest() == 21);
}

TEST_CASE("job: progress is seen while the work runs, and starts again with the next run") {
    std::atomic<int> started = 0;
    Job job(JobPolicy::supersede, Endless{&started});
    job.submit(-1);
    REQUIRE(eventually([&] { return job.progress() == 0.5F; }));
    CHECK(job.busy());
    job.cancel();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(job.latest() == nullptr);
}

TEST_CASE("job: cancelled, the last answer stays and the next request is answered") {
    std::atomic<int> started = 0;
    Job job(JobPolicy::finish, Endless{&started});
    job.submit(4);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    job.submit(-1);
    REQUIRE(eventually([&] { return started == 2; }));
    job.submit(-2);
    job.cancel();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(started == 2);  // -2 was forgotten
    CHECK(*job.latest() == 4);
    job.submit(5);
    REQUIRE(eventually([&] { return *job.latest() == 5; }));
}

TEST_CASE("job: its end stops what runs, and is quick") {
    std::atomic<int> started = 0;
    auto job = std::make_unique<Job>(JobPolicy::finish, Endless{&started});
    job->submit(-1);
    REQUIRE(eventually([&] { return started == 1; }));
    job->submit(-2);
    const auto begin = Clock::now();
    job.reset();
    CHECK(Clock::now() - begin < 200ms);
    CHECK(started == 1);
}

TEST_CASE("job: ends at once when it was never asked anything") {
    const auto begin = Clock::now();
    { const Job job(JobPolicy::supersede, doubled); }
    CHECK(Clock::now() - begin < 200ms);
}

TEST_CASE("job: the window is woken after the answer is there") {
    std::mutex mutex;
    std::vector<int> seen;
    Job* self = nullptr;
    Job job(JobPolicy::finish, doubled, [&] {
        const std::lock_guard lock(mutex);
        seen.push_back(*self->latest());
    });
    self = &job;
    job.submit(21);
    REQUIRE(eventually([&] {
        const std::lock_guard lock(mutex);
        return !seen.empty();
    }));
    CHECK(seen.back() == 42);
    CHECK_FALSE(job.busy());
}

TEST_CASE("job: a snapshot taken by a frame survives the next answers") {
    Job job(JobPolicy::finish, doubled);
    job.submit(1);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    const auto drawn = job.latest();
    job.submit(2);
    REQUIRE(eventually([&] { return *job.latest() == 4; }));
    CHECK(*drawn == 2);
}

TEST_CASE("job: work that throws is no answer, says why, and the next request is answered") {
    Job job(JobPolicy::finish, [](const int& request, std::stop_token, std::atomic<float>&) {
        if (request == 2) throw std::bad_alloc();
        if (request == 3) return std::optional<int>(std::vector<int>().at(3));
        return std::optional(request);
    });
    const auto ask = [&job](int request) {
        job.submit(request);
        REQUIRE(eventually([&job] { return !job.busy(); }));
    };
    ask(1);
    CHECK(job.failure().empty());
    ask(2);
    CHECK(job.failure().find("not enough memory") != std::string::npos);
    CHECK(*job.latest() == 1);
    ask(3);
    CHECK(job.failure().find("the work failed") != std::string::npos);
    ask(4);
    CHECK(job.failure().empty());
    CHECK(*job.latest() == 4);
}

namespace {

// What takes its time to go, as a large answer does: until a test lets it, or else for ten seconds.
struct Gate {
    std::binary_semaphore may_go{0};
    std::atomic<int> waiting = 0;
    std::atomic<bool> was_let = false;
};

struct SlowToGo {
    int value = 0;
    std::shared_ptr<Gate> gate;

    SlowToGo(int is, std::shared_ptr<Gate> has) : value(is), gate(std::move(has)) {}
    SlowToGo(SlowToGo&&) = default;
    SlowToGo(const SlowToGo&) = delete;
    ~SlowToGo() {
        if (!gate) return;
        ++gate->waiting;
        gate->was_let = gate->may_go.try_acquire_for(10s);
    }
};

}  // namespace

TEST_CASE("job: a frame never waits for an old answer, or an old request, to be freed") {
    const auto gate = std::make_shared<Gate>();
    LatestJob<int, SlowToGo> job(
        JobPolicy::finish, [&](const int& request, std::stop_token, std::atomic<float>&) {
            return std::optional<SlowToGo>(std::in_place, request,
                                           request == 1 ? gate : std::shared_ptr<Gate>());
        });
    job.submit(1);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    job.submit(2);
    REQUIRE(eventually([&] { return gate->waiting == 1; }));
    CHECK(job.latest()->value == 2);
    CHECK_FALSE(job.busy());
    CHECK(job.failure().empty());
    job.submit(3);  // the next question has none either
    job.cancel();
    gate->may_go.release();
    REQUIRE(eventually([&] { return gate->was_let.load(); }));

    const auto second = std::make_shared<Gate>();
    LatestJob<SlowToGo, int> asked(
        JobPolicy::finish, [](const SlowToGo& request, std::stop_token, std::atomic<float>&) {
            return std::optional(request.value);
        });
    asked.submit({1, second});
    REQUIRE(eventually([&] { return second->waiting == 1; }));
    CHECK(*asked.latest() == 1);
    asked.submit({2, nullptr});
    second->may_go.release();
    REQUIRE(eventually([&] { return *asked.latest() == 2; }));
    CHECK(second->was_let);
}

TEST_CASE("job: what is thrown after a stop is nobody's failure, and stops nothing that follows") {
    std::atomic<int> started = 0;
    Job job(JobPolicy::supersede,
            [&](const int& request, std::stop_token stop, std::atomic<float>&) {
                ++started;
                while (request < 0 && !stop.stop_requested()) std::this_thread::sleep_for(100us);
                if (request < 0) throw std::bad_alloc();
                return std::optional(request);
            });
    job.submit(-1);
    REQUIRE(eventually([&] { return started == 1; }));
    job.cancel();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(job.failure().empty());
    job.submit(-2);
    REQUIRE(eventually([&] { return started == 2; }));
    job.submit(3);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    CHECK(*job.latest() == 3);
    CHECK(job.failure().empty());
}

TEST_CASE("job: an answer that cannot be kept is a failure like one that cannot be made") {
    struct Unkept {
        int value = 0;
        explicit Unkept(int is) : value(is) {}
        Unkept(const Unkept& other) : value(other.value) {
            if (value == 2) throw std::bad_alloc();
        }
    };
    LatestJob<int, Unkept> job(JobPolicy::finish,
                               [](const int& request, std::stop_token, std::atomic<float>&) {
                                   return std::optional<Unkept>(std::in_place, request);
                               });
    job.submit(1);
    REQUIRE(eventually([&] { return job.latest() != nullptr; }));
    job.submit(2);
    REQUIRE(eventually([&] { return !job.failure().empty(); }));
    CHECK(job.failure().find("not enough memory") != std::string::npos);
    CHECK(job.latest()->value == 1);
}

TEST_CASE("job: parts of an answer are there before it, and none after a stop") {
    std::binary_semaphore may_end(0);
    std::atomic<int> woken = 0;
    Job job(JobPolicy::supersede,
            Job::WorkInParts([&](const int& request, std::stop_token stop, std::atomic<float>&,
                                 const Job::Partly& partly) -> std::optional<int> {
                partly(request + 1);
                partly(request + 2);
                may_end.acquire();
                partly(request + 3);
                if (stop.stop_requested()) return std::nullopt;
                return request;
            }),
            [&] { ++woken; });
    job.submit(10);
    REQUIRE(eventually([&] { return woken == 2; }));
    CHECK(job.busy());
    CHECK(*job.latest() == 12);
    may_end.release();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(*job.latest() == 10);
    job.submit(20);
    REQUIRE(eventually([&] { return *job.latest() == 22; }));
    job.cancel();
    may_end.release();
    REQUIRE(eventually([&] { return !job.busy(); }));
    CHECK(*job.latest() == 22);
}

}  // namespace latest_job_test
