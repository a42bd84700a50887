#include "app/jobs/background.h"

#include <sys/resource.h>

namespace tact {

void give_way_to_interface() {
#ifdef __linux__
    // Niceness of the calling thread alone, on Linux; children inherit it. A tenth of the weight
    // that the window has, which may be nice itself.
    constexpr int kNicer = 10;
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNicer);
#endif
}

}  // namespace tact
