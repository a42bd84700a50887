#include "model/system/open_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace tact {

namespace fs = std::filesystem;

namespace {

std::error_code fault_of(int answer) {
    return answer < 0 ? std::error_code(errno, std::generic_category()) : std::error_code();
}

FileFacts facts_in(const struct stat& about) {
    FileFacts facts;
    facts.bytes = static_cast<std::uint64_t>(std::max<off_t>(about.st_size, 0));
    if (S_ISDIR(about.st_mode)) {
        facts.kind = FileKind::folder;
    } else if (S_ISFIFO(about.st_mode)) {
        facts.kind = FileKind::pipe;
    } else if (S_ISSOCK(about.st_mode)) {
        facts.kind = FileKind::socket;
    } else if (!S_ISREG(about.st_mode)) {
        facts.kind = FileKind::device;
    }
    return facts;
}

int flags_of(FileUse use) {
    switch (use) {
        case FileUse::read:
            return O_RDONLY | O_NONBLOCK | O_NOCTTY;
        case FileUse::write_to:
            return O_WRONLY;
        case FileUse::make:
            return O_WRONLY | O_CREAT | O_EXCL | O_APPEND;
        case FileUse::extend:
            return O_RDWR | O_APPEND | O_NONBLOCK | O_NOCTTY;
        case FileUse::extend_or_make:
            return O_RDWR | O_APPEND | O_NONBLOCK | O_NOCTTY | O_CREAT;
    }
    return O_RDONLY;
}

}  // namespace

OpenFile::OpenFile(const fs::path& path, FileUse use, unsigned mode, std::error_code& fault)
    : descriptor_(::open(path.c_str(), flags_of(use) | O_CLOEXEC, mode)) {
    fault = fault_of(descriptor_);
}

OpenFile::~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

FileFacts OpenFile::facts(std::error_code& fault) const {
    struct stat about {};
    fault = fault_of(::fstat(descriptor_, &about));
    return facts_in(about);
}

std::size_t OpenFile::read(char* bytes, std::size_t size, std::error_code& fault) {
    ssize_t got = 0;
    do {
        got = ::read(descriptor_, bytes, size);
    } while (got < 0 && errno == EINTR);
    fault = fault_of(got < 0 ? -1 : 0);
    return static_cast<std::size_t>(std::max<ssize_t>(got, 0));
}

std::size_t OpenFile::read_at(std::uint64_t place, void* bytes, std::size_t size) const {
    std::size_t so_far = 0;
    while (so_far < size) {
        const ssize_t got = ::pread(descriptor_, static_cast<char*>(bytes) + so_far, size - so_far,
                                    static_cast<off_t>(place + so_far));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        so_far += static_cast<std::size_t>(got);
    }
    return so_far;
}

std::error_code OpenFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return fault_of(-1);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
}

std::error_code OpenFile::cut(std::uint64_t bytes) {
    return fault_of(::ftruncate(descriptor_, static_cast<off_t>(bytes)));
}

std::error_code OpenFile::sync() { return fault_of(::fsync(descriptor_)); }

std::error_code OpenFile::sync_content() { return fault_of(::fdatasync(descriptor_)); }

std::error_code OpenFile::close() { return fault_of(::close(std::exchange(descriptor_, -1))); }

bool OpenFile::lock() {
    return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

std::error_code OpenFile::take_owner_and_mode_of(const fs::path& other) {
    struct stat about {};
    if (::stat(other.c_str(), &about) != 0) return fault_of(-1);
    // The owner first, as that clears bits of the mode. Only root may give files away.
    [[maybe_unused]] const int owned = ::fchown(descriptor_, about.st_uid, about.st_gid);
    return fault_of(::fchmod(descriptor_, about.st_mode & 07777));
}

FileFacts facts_of(const fs::path& path, std::error_code& fault) {
    struct stat about {};
    fault = fault_of(::stat(path.c_str(), &about));
    return facts_in(about);
}

std::error_code writing_fault(const fs::path& path) {
    return fault_of(::access(path.c_str(), W_OK));
}

std::error_code put_in_place_of(const fs::path& file, const fs::path& old) {
    return fault_of(::rename(file.c_str(), old.c_str()));
}

void remove_at_once(const char* file) noexcept { ::unlink(file); }

bool is_own_and_older_than(const fs::path& file, std::int64_t seconds) {
    struct stat about {};
    if (::lstat(file.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return false;
    return about.st_mtime < std::time(nullptr) - seconds && about.st_uid == ::geteuid();
}

void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace tact
