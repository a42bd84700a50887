#include "model/system/kept_threads.h"
#include "model/system/process.h"
#include "model/system/together.h"

namespace tact {

// The threads are never waited for: the browser ends them with the page.
void call_together(std::size_t others, const std::function<void()>& work) {
    static KeptThreads& kept = *new KeptThreads;
    kept.call(has_threads() ? others : 0, work);
}

}  // namespace tact
