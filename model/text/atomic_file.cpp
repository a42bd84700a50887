#include "model/text/atomic_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include "model/system/process.h"
#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Error not_written(const fs::path& path, std::error_code fault) {
    return Error{path.string() + ": cannot be written: " + fault.message()};
}

Error not_written(const fs::path& path, std::errc why) {
    return not_written(path, std::make_error_code(why));
}

Error not_read(const fs::path& path, std::error_code fault) {
    if (fault == std::errc::no_such_file_or_directory) {
        return Error{path.string() + ": there is no such file"};
    }
    return Error{path.string() + ": cannot be read: " + fault.message()};
}

// What a path names instead of a file, as the end of a sentence; empty: a file.
std::string kind_fault(FileKind kind) {
    switch (kind) {
        case FileKind::file:
            return {};
        case FileKind::folder:
            return "is a folder, expected a file";
        case FileKind::pipe:
            return "is a pipe, expected a file";
        case FileKind::socket:
            return "is a socket, expected a file";
        case FileKind::device:
            return "is a device, expected a file";
    }
    return {};
}

// Why a file cannot be read, or empty.
std::string reading_fault(const FileFacts& facts, std::size_t most_bytes) {
    if (std::string fault = kind_fault(facts.kind); !fault.empty()) return fault;
    if (facts.bytes <= most_bytes) return {};
    return "expected at most " + grouped_digits(most_bytes) + " bytes";
}

constexpr std::string_view kTemporaryBegin = ".tactspace-";
constexpr std::string_view kTemporaryEnd = ".part";

// The process that a temporary file's name says made it; 0: another program's.
std::int64_t maker_of(std::string_view name) {
    if (!name.starts_with(kTemporaryBegin) || !name.ends_with(kTemporaryEnd)) return 0;
    name.remove_prefix(kTemporaryBegin.size());
    std::int64_t maker = 0;
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
        if (const char* const name = place.exchange(nullptr)) remove_at_once(name);
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
      file_(std::move(other.file_)) {}

AtomicFile::~AtomicFile() {
    file_ = {};
    if (!temporary_.empty()) remove_at_once(temporary_.c_str());
    forget(noted_);
}

Expected<AtomicFile> AtomicFile::open(const fs::path& path, unsigned new_mode) {
    AtomicFile file(path);
    file.target_ = link_target(path);
    if (file.target_.empty()) return not_written(path, std::errc::too_many_symbolic_link_levels);
    std::error_code fault;
    const FileFacts old = facts_of(file.target_, fault);
    const bool exists = !fault;
    if (exists && old.kind == FileKind::folder) return not_written(path, std::errc::is_a_directory);
    if (exists) fault = writing_fault(file.target_);
    if (exists && fault) return not_written(path, fault);
    if (exists && old.kind != FileKind::file) {
        file.file_ = OpenFile(file.target_, FileUse::write_to, 0, fault);
        if (fault) return not_written(path, fault);
        return file;
    }
    if (auto opened = file.open_temporary(exists ? 0600 : mode_of_new(file.target_, new_mode));
        !opened)
        return opened.error();
    if (exists) fault = file.file_.take_owner_and_mode_of(file.target_);
    if (exists && fault) return not_written(path, fault);
    return file;
}

Expected<Done> AtomicFile::open_temporary(unsigned mode) {
    // Not mkstemp: of a new file the system makes the mode, as the umask cannot be read without a
    // race.
    static std::atomic<unsigned> serial{0};
    for (;;) {
        std::string name(kTemporaryBegin);
        name += std::to_string(own_process()) + "-" + std::to_string(serial++);
        name += kTemporaryEnd;
        const fs::path file = folder_of(target_) / name;
        // Noted before it is there: a signal may come in between.
        noted_ = noted(file);
        std::error_code fault;
        file_ = OpenFile(file, FileUse::make, mode, fault);
        if (!fault) {
            temporary_ = file;
            return Done{};
        }
        forget(std::exchange(noted_, nullptr));
        if (fault != std::errc::file_exists) return not_written(path_, fault);
    }
}

Expected<Done> AtomicFile::append(std::string_view bytes) {
    if (const std::error_code fault = file_.write(bytes)) return not_written(path_, fault);
    return Done{};
}

Expected<Done> AtomicFile::commit() {
    // Pipes and terminals cannot be synced, and need not be.
    std::error_code fault = temporary_.empty() ? std::error_code() : file_.sync();
    if (fault) return not_written(path_, fault);
    if (fault = file_.close(); fault) return not_written(path_, fault);
    if (temporary_.empty()) return Done{};
    if (fault = put_in_place_of(temporary_, target_); fault) return not_written(path_, fault);
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
    constexpr std::int64_t kDayS = 24 * 60 * 60;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path& file = entry->path();
        const std::int64_t maker = maker_of(file.filename().string());
        if (maker == 0 || is_running(maker) || !is_own_and_older_than(file, kDayS)) continue;
        std::error_code none;
        fs::remove(file, none);
    }
}

Expected<std::size_t> readable_size(const fs::path& path) {
    std::error_code fault;
    const FileFacts facts = facts_of(path, fault);
    if (fault) return not_read(path, fault);
    if (const std::string why = reading_fault(facts, kMaxFileBytes); !why.empty()) {
        return Error{path.string() + ": " + why};
    }
    return static_cast<std::size_t>(facts.bytes);
}

Expected<std::string> read_text_file(const fs::path& path, std::size_t most_bytes) {
    // First by name, as opening alone makes some devices act; then what was opened.
    if (const auto size = readable_size(path); !size) return size.error();
    std::error_code fault;
    OpenFile file(path, FileUse::read, 0, fault);
    const FileFacts facts = fault ? FileFacts{} : file.facts(fault);
    if (fault) return not_read(path, fault);
    if (const std::string why = reading_fault(facts, most_bytes); !why.empty()) {
        return Error{path.string() + ": " + why};
    }
    // Read to the end, whatever the size said: files in /proc say 0, others may grow.
    constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
    std::string bytes;
    std::string piece(kPieceBytes, '\0');
    bytes.reserve(static_cast<std::size_t>(facts.bytes));
    for (;;) {
        const std::size_t count = file.read(piece.data(), piece.size(), fault);
        if (fault) return not_read(path, fault);
        if (count == 0) return bytes;
        bytes.append(piece, 0, count);
        if (bytes.size() > most_bytes) {
            return Error{path.string() + ": expected at most " + grouped_digits(most_bytes) +
                         " bytes"};
        }
    }
}

Expected<OpenFile> open_alone(const fs::path& path, bool make) {
    std::error_code fault;
    // First by name, then what was opened: as for reading.
    const FileFacts named = facts_of(path, fault);
    std::string why = fault ? std::string() : kind_fault(named.kind);
    if (!why.empty()) return Error{path.string() + ": " + why};
    OpenFile file(path, make ? FileUse::extend_or_make : FileUse::extend, mode_of_new(path, 0666),
                  fault);
    if (fault) return not_written(path, fault);
    const FileFacts opened = file.facts(fault);
    if (!fault) why = kind_fault(opened.kind);
    if (why.empty() && !file.lock()) {
        why = "another tactspace is writing it, expected to be alone";
    }
    if (why.empty()) return file;
    return Error{path.string() + ": " + why};
}

void sync_folder_of(const fs::path& file) { sync_folder(folder_of(file)); }

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
