// Whole files: read at once, and written so that a failure leaves the old file as it was.
//
// A file is written beside the old one, brought to the disk and then renamed over it. Links are
// followed and the mode is kept. A device or pipe is written to directly: a name is all it has.
//
// Output    errors as "PATH: cannot be written: REASON"
// Left out  locks, access control lists, extended attributes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;  // that are read

// A file being written. Without commit() the destructor leaves everything as it was.
class AtomicFile {
  public:
    static Expected<AtomicFile> open(const std::filesystem::path& path);

    // Best in large pieces: each is a system call.
    Expected<Done> append(std::string_view bytes);

    // Puts what was appended in the place of the old file. Once only, and last.
    Expected<Done> commit();

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

  private:
    explicit AtomicFile(std::filesystem::path path) : path_(std::move(path)) {}
    Expected<Done> open_temporary();

    std::filesystem::path path_;       // as asked for
    std::filesystem::path target_;     // with links followed
    std::filesystem::path temporary_;  // empty: none to remove
    int descriptor_ = -1;
};

Expected<Done> write_atomically(const std::filesystem::path& path, std::string_view bytes);

// The size of a file that can be read: there, not a folder, at most kMaxFileBytes.
Expected<std::size_t> readable_size(const std::filesystem::path& path);

// The bytes of a file of at most kMaxFileBytes.
Expected<std::string> read_text_file(const std::filesystem::path& path);

}  // namespace tact
