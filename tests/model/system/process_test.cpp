#include "model/system/process.h"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <thread>

namespace process_test {

using namespace tact;

#ifdef __linux__
namespace {

int niceness() { return getpriority(PRIO_PROCESS, 0); }

}  // namespace

TEST_CASE("process: work gives way to the window, however nice that is itself") {
    constexpr int kNicest = 19;
    const int of_window = niceness();
    int of_work = 0;
    int of_its_thread = 0;
    int after_another = 0;
    std::thread([&] {
        give_way();
        of_work = niceness();
        std::thread([&] { of_its_thread = niceness(); }).join();
        setpriority(PRIO_PROCESS, 0, kNicest);
        give_way();
        after_another = niceness();
    }).join();
    CHECK(niceness() == of_window);
    CHECK(of_work == std::min(of_window + 10, kNicest));
    CHECK(of_its_thread == of_work);
    CHECK(after_another == kNicest);
}
#endif

}  // namespace process_test
