#include "model/text/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::string reason(int code) { return std::generic_category().message(code); }

Error not_written(const fs::path& path, int code) {
    return Error{path.string() + ": cannot be written: " + reason(code)};
}

Error too_long(const fs::path& path) {
    return Error{path.string() + ": expected at most " + grouped_digits(kMaxFileBytes) + " bytes"};
}

// Where a path leads in the end; empty for links that go round in circles.
fs::path link_target(fs::path path) {
    constexpr int kMaxLinks = 40;  // as Linux has it
    for (int links = 0; links < kMaxLinks; ++links) {
        std::error_code none;
        const fs::path next = fs::read_symlink(path, none);
        if (none) return path;
        path = path.parent_path() / next;  // an absolute target replaces the folder
    }
    return {};
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// Without this a power cut can bring the old file back, whole; so a failure is none of ours.
void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Expected<AtomicFile> AtomicFile::open(const fs::path& path) {
    AtomicFile file(path);
    file.target_ = link_target(path);
    if (file.target_.empty()) return not_written(path, ELOOP);
    struct stat old {};
    const bool exists = ::stat(file.target_.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) return not_written(path, EISDIR);
    if (exists && ::access(file.target_.c_str(), W_OK) != 0) return not_written(path, errno);
    if (exists && !S_ISREG(old.st_mode)) {
        file.descriptor_ = ::open(file.target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (file.descriptor_ < 0) return not_written(path, errno);
        return file;
    }
    if (auto opened = file.open_temporary(); !opened) return opened.error();
    if (exists) {
        // The owner first, as that clears bits of the mode. Only root may give files away.
        [[maybe_unused]] const int owned = ::fchown(file.descriptor_, old.st_uid, old.st_gid);
        if (::fchmod(file.descriptor_, old.st_mode & 07777) != 0) return not_written(path, errno);
    }
    return file;
}

Expected<Done> AtomicFile::open_temporary() {
    // Not mkstemp: its mode 0600 would need the umask, which cannot be read without a race.
    static std::atomic<unsigned> serial{0};
    for (;;) {
        const fs::path name = folder_of(target_) / (".tactspace-" + std::to_string(::getpid()) +
                                                    "-" + std::to_string(serial++) + ".part");
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) {
            temporary_ = name;
            return Done{};
        }
        if (errno != EEXIST) return not_written(path_, errno);
    }
}

Expected<Done> AtomicFile::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return not_written(path_, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return Done{};
}

Expected<Done> AtomicFile::commit() {
    // Pipes and terminals cannot be synced, and need not be.
    if (!temporary_.empty() && ::fsync(descriptor_) != 0) return not_written(path_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) return not_written(path_, errno);
    if (temporary_.empty()) return Done{};
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) return not_written(path_, errno);
    temporary_.clear();
    sync_folder(folder_of(target_));
    return Done{};
}

Expected<Done> write_atomically(const fs::path& path, std::string_view bytes) {
    auto file = AtomicFile::open(path);
    if (!file) return file.error();
    if (auto appended = file->append(bytes); !appended) return appended;
    return file->commit();
}

Expected<std::size_t> readable_size(const fs::path& path) {
    const std::string name = path.string();
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0) {
        if (errno == ENOENT) return Error{name + ": there is no such file"};
        return Error{name + ": cannot be read: " + reason(errno)};
    }
    if (S_ISDIR(about.st_mode)) return Error{name + ": is a folder, expected a file"};
    if (about.st_size > static_cast<off_t>(kMaxFileBytes)) return too_long(path);
    return static_cast<std::size_t>(about.st_size);
}

Expected<std::string> read_text_file(const fs::path& path) {
    if (const auto size = readable_size(path); !size) return size.error();
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{path.string() + ": cannot be read: " + reason(errno)};
    // Read to the end, whatever the size said: files in /proc say 0, others may grow.
    std::string bytes;
    std::string piece(std::size_t{1} << 16, '\0');
    while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())),
           stream.gcount() > 0) {
        bytes.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > kMaxFileBytes) return too_long(path);
    }
    if (stream.bad()) return Error{path.string() + ": cannot be read: " + reason(errno)};
    return bytes;
}

}  // namespace tact
