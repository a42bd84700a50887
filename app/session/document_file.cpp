#include "app/session/session.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "model/common/fingerprint.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

std::filesystem::path lock_file_of(const Session& session, const std::filesystem::path& file) {
    std::error_code none;
    const std::string name = std::filesystem::weakly_canonical(file, none).string();
    return session.folder / "open" / (fingerprint_text(name) + ".lock");
}

}  // namespace

std::optional<std::uint64_t> content_mark(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text_file(file);
    if (!text) return std::nullopt;
    return fingerprint(*text);
}

bool hold_document(Session& session, const std::filesystem::path& file) {
    release_document(session);
    if (session.folder.empty() || file.empty()) return true;
    const std::filesystem::path lock_file = lock_file_of(session, file);
    if (!make_folder(lock_file.parent_path())) return true;
    std::optional<FileLock> lock = try_lock(lock_file);
    if (!lock) return !is_there(lock_file);
    session.document_lock = std::make_shared<FileLock>(*std::move(lock));
    session.document_lock_file = lock_file;
    return true;
}

void release_document(Session& session) {
    if (!session.document_lock) return;
    std::error_code none;
    std::filesystem::remove(session.document_lock_file, none);
    session.document_lock.reset();
}

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
