#include "model/system/process.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>

namespace tact {

std::int64_t own_process() { return ::getpid(); }

bool is_running(std::int64_t process) {
    return ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

bool has_threads() { return true; }

int bound_processors(int machine) {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(CPU_COUNT(&set), 1);
    return machine;  // more than a cpu_set_t holds
}

void give_way() {
    // Niceness of the calling thread alone, on Linux; children inherit it. A tenth of the weight
    // that the window has, which may be nice itself.
    constexpr int kNicer = 10;
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNicer);
}

bool threads_weigh_alike() { return false; }

}  // namespace tact
