#include "model/common/processors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "model/common/parallel.h"
#include "tests/support/temporary_folder.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace processors_test {

using namespace tact;

namespace {

void write(const std::filesystem::path& file, const char* text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("processors: no more are used than were given, whoever gave them") {
    CHECK(usable_processors({.machine = 64, .bound = 64}) == 64);
    CHECK(usable_processors({.machine = 64, .bound = 4}) == 4);
    CHECK(usable_processors({.machine = 64, .bound = 64, .quota = 2.5}) == 3);
    CHECK(usable_processors({.machine = 64, .bound = 64, .quota = 0.2}) == 1);
    CHECK(usable_processors({.machine = 64, .bound = 64, .per_task = 8}) == 8);
    CHECK(usable_processors({.machine = 4, .bound = 4, .per_task = 8}) == 4);
    // Ranks share a machine, unless each has processors of its own.
    CHECK(usable_processors({.machine = 64, .bound = 64, .ranks = 16}) == 4);
    CHECK(usable_processors({.machine = 64, .bound = 4, .ranks = 16}) == 4);
    CHECK(usable_processors({.machine = 64, .bound = 64, .per_task = 4, .ranks = 16}) == 4);
    CHECK(usable_processors({.machine = 2, .bound = 2, .ranks = 5}) == 1);
}

TEST_CASE("processors: the quota is the least of a group and of those around it") {
    const TemporaryFolder folder;
    const auto& root = folder.path;
    CHECK(std::isinf(processor_quota(root, "0::/user/job\n")));
    write(root / "user" / "job" / "cpu.max", "max 100000\n");
    CHECK(std::isinf(processor_quota(root, "0::/user/job\n")));
    write(root / "user" / "cpu.max", "150000 100000\n");
    CHECK(processor_quota(root, "0::/user/job\n") == 1.5);
    write(root / "user" / "job" / "cpu.max", "50000 100000\n");
    CHECK(processor_quota(root, "0::/user/job\n") == 0.5);
    CHECK(processor_quota(root, "0::/\n") > 1e9);
    // Version 1 has a hierarchy for each controller.
    write(root / "cpu" / "task" / "cpu.cfs_quota_us", "400000\n");
    write(root / "cpu" / "task" / "cpu.cfs_period_us", "100000\n");
    CHECK(processor_quota(root, "5:devices:/task\n1:cpu,cpuacct:/task\n") == 4.0);
    write(root / "cpu" / "task" / "cpu.cfs_quota_us", "-1\n");
    CHECK(std::isinf(processor_quota(root, "1:cpu,cpuacct:/task\n")));
    CHECK(std::isinf(processor_quota(root, "nothing of the kind\n::\n")));
}

#ifdef __linux__
TEST_CASE("processors: a process that is bound to one starts no more threads") {
    cpu_set_t before;
    REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int k = 0; k < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++k) {
        if (CPU_ISSET(k, &before)) CPU_SET(k, &one);
    }
    REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
    CHECK(thread_count(0) == 1);
    CHECK(thread_count(3) == 3);  // asked for
    REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
    CHECK(thread_count(0) == usable_processors());
}
#endif

}  // namespace processors_test
