#include "devices/http/small_thread.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace tact {

namespace {

constexpr std::size_t kStackBytes = 256 * 1024;

void* run_task(void* task) {
    const std::unique_ptr<std::function<void()>> owned(static_cast<std::function<void()>*>(task));
    (*owned)();
    return nullptr;
}

}  // namespace

bool start_small_thread(pthread_t& thread, std::function<void()> run) {
    auto task = std::make_unique<std::function<void()>>(std::move(run));
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_attr_setstacksize(&attributes, kStackBytes);
    const bool started = pthread_create(&thread, &attributes, run_task, task.get()) == 0;
    pthread_attr_destroy(&attributes);
    if (started) (void)task.release();  // the thread's now
    return started;
}

}  // namespace tact
