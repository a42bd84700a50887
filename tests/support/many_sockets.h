// Room for a hall of phones in one process: both ends of every connection are in it.
#pragma once

#include <sys/resource.h>

#include <algorithm>

namespace tact {

inline void allow_many_sockets() {
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 4096);
    setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace tact
