#include "model/text/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::string reason(int code) { return std::generic_category().message(code); }

Error not_written(const fs::path& path, int code) {
    return Error{path.string() + ": cannot be written: " + reason(code)};
}

Error not_read(const fs::path& path, int code) {
    if (code == ENOENT) return Error{path.string() + ": there is no such file"};
    return Error{path.string() + ": cannot be read: " + reason(code)};
}

// What a path names instead of a file, as the end of a sentence; empty: a file.
std::string kind_fault(const struct stat& about) {
    if (S_ISDIR(about.st_mode)) return "is a folder, expected a file";
    if (S_ISFIFO(about.st_mode)) return "is a pipe, expected a file";
    if (S_ISSOCK(about.st_mode)) return "is a socket, expected a file";
    if (!S_ISREG(about.st_mode)) return "is a device, expected a file";
    return {};
}

// Why a file cannot be read, or empty.
std::string reading_fault(const struct stat& about, std::size_t most_bytes) {
    if (std::string fault = kind_fault(about); !fault.empty()) return fault;
    if (about.st_size <= static_cast<off_t>(most_bytes)) return {};
    return "expected at most " + grouped_digits(most_bytes) + " bytes";
}

// Closes when it goes.
struct Descriptor {
    int number = -1;

    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

constexpr std::string_view kTemporaryBegin = ".tactspace-";
constexpr std::string_view kTemporaryEnd = ".part";

// The process that a temporary file's name says made it; 0: another program's.
pid_t maker_of(std::string_view name) {
    if (!name.starts_with(kTemporaryBegin) || !name.ends_with(kTemporaryEnd)) return 0;
    name.remove_prefix(kTemporaryBegin.size());
    pid_t maker = 0;
    const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), maker);
    return fault == std::errc{} && *end == '-' && maker > 0 ? maker : 0;
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

// A handler of signals has no arguments of ours: names of temporary files lie where it finds them.
// Whoever takes one out of its place owns it, so that a handler never reads what is freed.
std::array<std::atomic<char*>, 64> unfinished{};

char* noted(const fs::path& temporary) {
    char* const name = ::strdup(temporary.c_str());
    for (std::atomic<char*>& place : unfinished) {
        char* free = nullptr;
        if (name != nullptr && place.compare_exchange_strong(free, name)) return name;
    }
    std::free(name);
    return nullptr;
}

void forget(char* name) {
    for (std::atomic<char*>& place : unfinished) {
        char* expected = name;
        if (name == nullptr || !place.compare_exchange_strong(expected, nullptr)) continue;
        std::free(name);
        return;
    }
}

// Folders of which nobody else reads anything; like the umask, of the whole process.
struct PrivateFolders {
    std::mutex mutex;
    std::vector<fs::path> folders;
};

PrivateFolders& private_folders() {
    static PrivateFolders the_folders;
    return the_folders;
}

fs::path resolved(const fs::path& path) {
    std::error_code none;
    fs::path whole = fs::weakly_canonical(fs::absolute(path, none), none);
    return none ? path : whole;
}

}  // namespace

void remove_unfinished_files() {
    for (std::atomic<char*>& place : unfinished) {
        if (const char* const name = place.exchange(nullptr)) ::unlink(name);
    }
}

void keep_new_files_private_in(const fs::path& folder) {
    PrivateFolders& all = private_folders();
    const std::scoped_lock lock(all.mutex);
    fs::path whole = resolved(folder);
    if (std::ranges::find(all.folders, whole) == all.folders.end()) {
        all.folders.push_back(std::move(whole));
    }
}

unsigned mode_of_new(const fs::path& path, unsigned usual) {
    PrivateFolders& all = private_folders();
    const std::scoped_lock lock(all.mutex);
    if (all.folders.empty()) return usual;
    const fs::path whole = resolved(path);
    const bool is_private = std::ranges::any_of(all.folders, [&whole](const fs::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end()).first ==
               folder.end();
    });
    constexpr unsigned kOwner = 0700;
    return is_private ? usual & kOwner : usual;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      noted_(std::exchange(other.noted_, nullptr)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    forget(noted_);
}

Expected<AtomicFile> AtomicFile::open(const fs::path& path, unsigned new_mode) {
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
    if (auto opened = file.open_temporary(exists ? 0600 : mode_of_new(file.target_, new_mode));
        !opened)
        return opened.error();
    if (exists) {
        // The owner first, as that clears bits of the mode. Only root may give files away.
        [[maybe_unused]] const int owned = ::fchown(file.descriptor_, old.st_uid, old.st_gid);
        if (::fchmod(file.descriptor_, old.st_mode & 07777) != 0) return not_written(path, errno);
    }
    return file;
}

Expected<Done> AtomicFile::open_temporary(unsigned mode) {
    // Not mkstemp: of a new file the system makes the mode, as the umask cannot be read without a
    // race.
    static std::atomic<unsigned> serial{0};
    for (;;) {
        std::string name(kTemporaryBegin);
        name += std::to_string(::getpid()) + "-" + std::to_string(serial++);
        name += kTemporaryEnd;
        const fs::path file = folder_of(target_) / name;
        // Noted before it is there: a signal may come in between.
        noted_ = noted(file);
        descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (descriptor_ >= 0) {
            temporary_ = file;
            return Done{};
        }
        const int code = errno;
        forget(std::exchange(noted_, nullptr));
        if (code != EEXIST) return not_written(path_, code);
    }
}

Expected<Done> AtomicFile::append(std::string_view bytes) {
    if (!write_all(descriptor_, bytes)) return not_written(path_, errno);
    return Done{};
}

Expected<Done> AtomicFile::commit() {
    // Pipes and terminals cannot be synced, and need not be.
    if (!temporary_.empty() && ::fsync(descriptor_) != 0) return not_written(path_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) return not_written(path_, errno);
    if (temporary_.empty()) return Done{};
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) return not_written(path_, errno);
    temporary_.clear();
    forget(std::exchange(noted_, nullptr));
    sync_folder_of(target_);
    return Done{};
}

Expected<Done> write_atomically(const fs::path& path, std::string_view bytes, unsigned new_mode) {
    auto file = AtomicFile::open(path, new_mode);
    if (!file) return file.error();
    if (auto appended = file->append(bytes); !appended) return appended;
    return file->commit();
}

void remove_abandoned_files(const fs::path& folder) {
    constexpr std::time_t kDayS = 24 * 60 * 60;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path& file = entry->path();
        const pid_t maker = maker_of(file.filename().native());
        if (maker == 0 || ::kill(maker, 0) == 0 || errno != ESRCH) continue;
        struct stat about {};
        if (::lstat(file.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) continue;
        const bool is_old = about.st_mtime < std::time(nullptr) - kDayS;
        if (is_old && about.st_uid == ::geteuid()) ::unlink(file.c_str());
    }
}

Expected<std::size_t> readable_size(const fs::path& path) {
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0) return not_read(path, errno);
    if (const std::string fault = reading_fault(about, kMaxFileBytes); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    return static_cast<std::size_t>(about.st_size);
}

Expected<std::string> read_text_file(const fs::path& path, std::size_t most_bytes) {
    // First by name, as opening alone makes some devices act; then what was opened.
    if (const auto size = readable_size(path); !size) return size.error();
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat about {};
    if (file.number < 0 || ::fstat(file.number, &about) != 0) return not_read(path, errno);
    if (const std::string fault = reading_fault(about, most_bytes); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    // Read to the end, whatever the size said: files in /proc say 0, others may grow.
    constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
    std::string bytes;
    std::string piece(kPieceBytes, '\0');
    bytes.reserve(static_cast<std::size_t>(about.st_size));
    for (;;) {
        const ssize_t count = ::read(file.number, piece.data(), piece.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return not_read(path, errno);
        if (count == 0) return bytes;
        bytes.append(piece, 0, static_cast<std::size_t>(count));
        if (bytes.size() > most_bytes) {
            return Error{path.string() + ": expected at most " + grouped_digits(most_bytes) +
                         " bytes"};
        }
    }
}

Expected<int> open_alone(const fs::path& path, bool make) {
    struct stat about {};
    // First by name, then what was opened: as for reading.
    const bool is_there = ::stat(path.c_str(), &about) == 0;
    std::string fault = is_there ? kind_fault(about) : std::string();
    if (!fault.empty()) return Error{path.string() + ": " + fault};
    const int flags = O_RDWR | O_APPEND | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (make ? O_CREAT : 0);
    const int descriptor = ::open(path.c_str(), flags, mode_of_new(path, 0666));
    if (descriptor < 0) return not_written(path, errno);
    if (::fstat(descriptor, &about) == 0) fault = kind_fault(about);
    // A file system without locks must not keep anyone from working.
    if (fault.empty() && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        fault = "another tactspace is writing it, expected to be alone";
    }
    if (fault.empty()) return descriptor;
    ::close(descriptor);
    return Error{path.string() + ": " + fault};
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

void sync_folder_of(const fs::path& file) {
    const int descriptor = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

std::string head_of_file(const fs::path& path, std::size_t bytes) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return {};
    std::string head(bytes, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

}  // namespace tact
