// A library for LD_PRELOAD: the system calls that write below one folder, of which one fails, or
// all from that one on, or before which a signal arrives. For tests/faults and tests/endings.
//
// Input     FAULTS_UNDER the folder; FAULTS_AT which call, from 1 (0: none); FAULTS_ERRNO its
// errno;
//           FAULTS_ON where set, later calls fail too, as on a full disk; FAULTS_SHORT where set, a
//           write that is to fail takes half of the bytes, and the next one fails; FAULTS_SIGNAL
//           where set, no call fails, and the process gets this signal before that one
// Output    FAULTS_COUNT a file that gets the number of calls
// Left out  unlink: what tidies up is to work. Calls that glibc makes within itself, as of stdio.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> calls{0};

const char* text_of(const char* name) { return std::getenv(name); }

long number_of(const char* name) {
    const char* text = text_of(name);
    return text == nullptr ? 0 : std::strtol(text, nullptr, 10);
}

bool is_under(const char* path) {
    static const char* const folder = text_of("FAULTS_UNDER");
    return folder != nullptr && path != nullptr &&
           std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_under(int descriptor) {
    char link[64];
    char path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = ::readlink(link, path, sizeof path - 1);
    if (length < 0) return false;
    path[length] = '\0';
    return is_under(path);
}

struct Plan {
    long at = number_of("FAULTS_AT");
    int code = static_cast<int>(number_of("FAULTS_ERRNO"));
    int signal = static_cast<int>(number_of("FAULTS_SIGNAL"));
    bool on = text_of("FAULTS_ON") != nullptr;
    bool cuts = text_of("FAULTS_SHORT") != nullptr;
};

const Plan& plan() {
    static const Plan the_plan;
    return the_plan;
}

bool was_cut = false;  // so the next call fails

// Counts a call; whether it is one that fails, with its errno set.
bool fails() {
    const long k = ++calls;
    if (plan().at == 0) return false;
    if (plan().signal != 0) {
        if (k == plan().at) ::kill(::getpid(), plan().signal);
        return false;
    }
    const bool is_it = k == plan().at || (was_cut && k == plan().at + 1);
    if (!is_it && !(plan().on && k > plan().at)) return false;
    errno = plan().code;
    return true;
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool writes(int flags) { return (flags & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) != 0; }

int opened(const char* name, const char* path, int flags, mode_t mode) {
    if (writes(flags) && is_under(path) && fails()) return -1;
    return next<int(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t mode_in(int flags, va_list& rest) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(rest, int)) : 0;
}

std::FILE* stream_opened(const char* name, const char* path, const char* how) {
    const bool is_read = how[0] == 'r' && std::strchr(how, '+') == nullptr;
    if (!is_read && is_under(path) && fails()) return nullptr;
    return next<std::FILE*(const char*, const char*)>(name)(path, how);
}

struct CountAtEnd {
    ~CountAtEnd() {
        const char* file = text_of("FAULTS_COUNT");
        if (file == nullptr) return;
        const long descriptor =
            ::syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
        char digits[32];
        const int length = std::snprintf(digits, sizeof digits, "%ld\n", calls.load());
        ::syscall(SYS_write, descriptor, digits, static_cast<std::size_t>(length));
        ::syscall(SYS_close, descriptor);
    }
};
CountAtEnd count_at_end;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("open64", path, flags, mode);
}

std::FILE* fopen(const char* path, const char* how) { return stream_opened("fopen", path, how); }
std::FILE* fopen64(const char* path, const char* how) {
    return stream_opened("fopen64", path, how);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    auto* const real = next<ssize_t(int, const void*, size_t)>("write");
    if (!is_under(descriptor)) return real(descriptor, bytes, count);
    if (plan().cuts && count > 1 && calls + 1 == plan().at) {
        ++calls;
        was_cut = true;
        return real(descriptor, bytes, count / 2);
    }
    return fails() ? -1 : real(descriptor, bytes, count);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    if (is_under(descriptor) && fails()) return -1;
    return next<ssize_t(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

int fsync(int descriptor) {
    if (is_under(descriptor) && fails()) return -1;
    return next<int(int)>("fsync")(descriptor);
}

int fdatasync(int descriptor) {
    if (is_under(descriptor) && fails()) return -1;
    return next<int(int)>("fdatasync")(descriptor);
}

int ftruncate(int descriptor, off_t length) noexcept {
    if (is_under(descriptor) && fails()) return -1;
    return next<int(int, off_t)>("ftruncate")(descriptor, length);
}

int rename(const char* from, const char* to) noexcept {
    if (is_under(to) && fails()) return -1;
    return next<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
    if (is_under(path) && fails()) return -1;
    return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
