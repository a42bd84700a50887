// Whole files: read at once, and written so that a failure leaves the old file as it was.
//
// A file is written beside the old one, brought to the disk and then renamed over it. Links are
// followed and the mode is kept; nobody who may not read the old file can read the new one while it
// is made. A device or pipe is written to directly: a name is all it has. Only regular files are
// read, or written on: a pipe would block for ever, a device has no end.
//
// Output    errors as "PATH: cannot be written: REASON"
// Valid     reading: at most kMaxFileBytes, which readers that need more memory than the bytes
//           themselves lower, so that no file makes the program use more than 1 GB
// Left out  locks of what is written whole, access control lists, extended attributes. Another hard
//           link to a file keeps the old content, as renaming replaces only the name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/system/open_file.h"

namespace tact {

inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 29;  // that are read

// A file being written. Without commit() the destructor leaves everything as it was.
class AtomicFile {
  public:
    // `new_mode` is that of a file that was not there, less what the umask takes.
    static Expected<AtomicFile> open(const std::filesystem::path& path, unsigned new_mode = 0666);

    // Best in large pieces: each is a system call.
    Expected<Done> append(std::string_view bytes);

    // Puts what was appended in the place of the old file. Once only, and last.
    Expected<Done> commit();

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

  private:
    explicit AtomicFile(std::filesystem::path path) : path_(std::move(path)) {}
    Expected<Done> open_temporary(unsigned mode);

    std::filesystem::path path_;       // as asked for
    std::filesystem::path target_;     // with links followed
    std::filesystem::path temporary_;  // empty: none to remove
    char* noted_ = nullptr;            // where remove_unfinished_files() finds it
    OpenFile file_;
};

Expected<Done> write_atomically(const std::filesystem::path& path, std::string_view bytes,
                                unsigned new_mode = 0666);

// Removes the temporary files of all that is being written now: for a handler of signals that end
// the program, after which nothing is committed. Safe in one (signal-safety(7)).
void remove_unfinished_files();

// From now on new files and folders of this process in and below a folder are its owner's alone.
void keep_new_files_private_in(const std::filesystem::path& folder);

// The mode of a file or folder that is made there: the usual one, or of that what is the owner's.
unsigned mode_of_new(const std::filesystem::path& path, unsigned usual);

// Removes what programs that were killed while they wrote left in a folder: temporary files of this
// user whose process is gone and that nobody has written to for a day (on a shared disk the process
// may live elsewhere).
void remove_abandoned_files(const std::filesystem::path& folder);

// The size of a file that can be read: there, regular, at most kMaxFileBytes.
Expected<std::size_t> readable_size(const std::filesystem::path& path);

// The bytes of a regular file of at most `most_bytes`. Answers at once whatever the path names, and
// what is looked at is what is read.
Expected<std::string> read_text_file(const std::filesystem::path& path,
                                     std::size_t most_bytes = kMaxFileBytes);

// The first bytes of a regular file, to tell what it is by; empty where it cannot be read.
std::string head_of_file(const std::filesystem::path& path, std::size_t bytes = 4096);

// A regular file that grows while a program runs, to be read and appended to. Until it is closed no
// other program gets it: that, and whatever else the path names, is an Error at once. `make`: a
// missing file is made.
Expected<OpenFile> open_alone(const std::filesystem::path& path, bool make);

// A new file is safe from a power cut only when its folder is. A failure is nobody's: what is lost
// then is the name, not the file.
void sync_folder_of(const std::filesystem::path& file);

}  // namespace tact
