// A thread with a small stack: some hundreds of them wait most of the time.
//
// Source    pthread_attr_setstacksize(3). std::thread has no such choice, and takes 8 MB of
// addresses
//           each, all of which are memory where an audio library locks what the process has
#pragma once

#include <pthread.h>

#include <functional>

namespace tact {

// False: the system has no room for it. To be joined by pthread_join.
bool start_small_thread(pthread_t& thread, std::function<void()> run);

}  // namespace tact
