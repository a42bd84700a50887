// This process among the others of the system.
#pragma once

#include <cstdint>

namespace tact {

std::int64_t own_process();

// False for certain only if the system says that there is no such process.
bool is_running(std::int64_t process);

// Whether threads can be started: not in a page that its browser does not set apart from others.
bool has_threads();

// The processors that this process may use of a machine's; all of them where the system cannot say.
int bound_processors(int machine);

// From now on the calling thread, and those it starts, get a tenth of the time of others that want
// it; where the system weighs single threads.
void give_way();

// Whether give_way() has no effect, as in a browser.
bool threads_weigh_alike();

}  // namespace tact
