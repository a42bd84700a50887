// One function on several threads at the same time.
#pragma once

#include <cstddef>
#include <functional>

namespace tact {

// Calls `work` here and on up to `others` more threads; returns once all calls have ended. Fewer
// help where the system gives no more threads. `work` must not throw.
void call_together(std::size_t others, const std::function<void()>& work);

}  // namespace tact
