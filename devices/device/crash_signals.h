// Who has a signal of a crash already: nobody, a library that prints a stack where it likes (UCX
// does, which comes with MPI of Debian 13), or a sanitizer, whose report is the better one.
#pragma once

#include <csignal>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TACT_HAS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TACT_HAS_SANITIZER 1
#endif
#endif

namespace tact {

#ifdef TACT_HAS_SANITIZER
inline constexpr bool kHasSanitizer = true;
#else
inline constexpr bool kHasSanitizer = false;
#endif

// A handler that asks for details of the signal is a library's or a sanitizer's: none of ours does.
inline bool is_a_librarys(const struct sigaction& before) {
    return !kHasSanitizer && (before.sa_flags & SA_SIGINFO) != 0;
}

inline bool may_be_taken(const struct sigaction& before) {
    return (before.sa_flags & SA_SIGINFO) != 0 ? is_a_librarys(before)
                                               : before.sa_handler == SIG_DFL;
}

}  // namespace tact
