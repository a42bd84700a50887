// Work on independent indices with several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace tact {

// Calls work(index) once for every index in [0, count), each on some thread, until a stop is
// asked for. threads = 0: all cores. Returns when all are done or stopped; true if all were done.
//
// What `work` throws, such as for want of memory, ends the work and is thrown again here: of
// several exceptions the one of the lowest index, for any number of threads.
bool parallel_for(std::size_t count, int threads, std::stop_token stop,
                  const std::function<void(std::size_t)>& work);

// What threads = 0 stands for.
int thread_count(int threads);

}  // namespace tact
