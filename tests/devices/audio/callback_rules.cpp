// A program of its own: the audio callback under guard. It replaces malloc and the locks of the
// whole process by ones that count, and lets the callback run where the system forbids every call.
//
// Exact  a callback that allocates, locks or calls the system even once fails
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <dlfcn.h>
#include <doctest/doctest.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <vector>

#include "devices/device/playback.h"

#ifdef TACT_COUNTS_CALLS
namespace {

thread_local bool is_guarded = false;
thread_local int forbidden = 0;

void note() {
    if (is_guarded) ++forbidden;
}

// How many forbidden calls `work` makes on this thread.
int forbidden_calls(const std::function<void()>& work) {
    forbidden = 0;
    is_guarded = true;
    work();
    is_guarded = false;
    return forbidden;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
    note();
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    note();
    return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
    note();
    return __libc_realloc(block, size);
}
void free(void* block) {
    note();
    __libc_free(block);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
    note();
    using Lock = int (*)(pthread_mutex_t*);
    static const auto lock = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
    return lock(mutex);
}

}  // extern "C"
#endif

using namespace tact;

namespace {

Clip some_clip(std::uint64_t serial, bool loop) {
    Clip clip;
    clip.samples.assign(5000, 0.9F);
    clip.peak = 0.9F;
    clip.loop = loop;
    clip.serial = serial;
    return clip;
}

// All a callback ever does: silence, a clip to its end, a loop, a louder level, another clip, a
// stop, blocks of any length.
void use_callback(Playback& playback, const std::array<Clip, 4>& clips,
                  std::vector<float>& buffer) {
    const auto run = [&](int calls) {
        for (int call = 0; call < calls; ++call) {
            const auto frames = static_cast<std::size_t>(1 + call * 37 % 1024);
            render(playback, buffer.data(), frames, 0.01 * call, call % 5 == 0);
        }
    };
    run(20);
    for (const Clip& clip : clips) {
        playback.wanted = &clip;
        playback.level = 0.1F * static_cast<float>(clip.serial);
        run(50);
        playback.level = 1.0F;
        run(50);
    }
    playback.wanted = nullptr;
    run(50);
}

struct Prepared {
    Playback playback;
    // The last two are one play, which is changed.
    std::array<Clip, 4> clips{some_clip(1, false), some_clip(2, true), some_clip(3, true),
                              some_clip(3, true)};
    std::vector<float> buffer = std::vector<float>(4 * 1024);

    Prepared() { playback.layout = {48'000.0, 4, 1, kCeiling}; }
};

// Runs `work` in a child that may do nothing but read, write and exit; how that ended.
int end_in_strict_child(const std::function<void()>& work) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) syscall(SYS_exit, 77);
        work();
        syscall(SYS_exit, 0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return status;
}

}  // namespace

#ifdef TACT_COUNTS_CALLS
TEST_CASE("audio callback: it allocates nothing, frees nothing and takes no lock") {
    Prepared prepared;
    CHECK(forbidden_calls(
              [&] { use_callback(prepared.playback, prepared.clips, prepared.buffer); }) == 0);
    CHECK(prepared.playback.ended == 3);  // it did all that
    CHECK(notes_of(prepared.playback, 3).clipped);
    // The guard sees what it is there for.
    std::mutex mutex;
    CHECK(forbidden_calls([] { std::vector<int>(10).shrink_to_fit(); }) >= 2);
    CHECK(forbidden_calls([&] { const std::lock_guard lock(mutex); }) == 1);
}
#endif

TEST_CASE("audio callback: it runs where every system call is forbidden") {
    Prepared prepared;
    const int guarded = end_in_strict_child(
        [&] { use_callback(prepared.playback, prepared.clips, prepared.buffer); });
    REQUIRE_MESSAGE(!(WIFEXITED(guarded) && WEXITSTATUS(guarded) == 77), "no seccomp here");
    CHECK(WIFEXITED(guarded));
    CHECK((WIFEXITED(guarded) && WEXITSTATUS(guarded) == 0));
    // The child's guard sees what it is there for.
    const int caught = end_in_strict_child([] { syscall(SYS_getpid); });
    CHECK(WIFSIGNALED(caught));
    CHECK(WTERMSIG(caught) == SIGKILL);
}
