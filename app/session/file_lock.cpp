#include "app/session/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace tact {

FileLock::~FileLock() {
    if (file_ >= 0) close(file_);
}

std::optional<FileLock> try_lock(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return std::nullopt;
    FileLock lock(file);
    // A file system without locks must not make every instance the second one.
    if (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return std::nullopt;
    // Whoever held it may have removed it meanwhile: then others would lock a file of that name.
    struct stat status {};
    if (fstat(file, &status) != 0 || status.st_nlink == 0) return std::nullopt;
    return lock;
}

}  // namespace tact
