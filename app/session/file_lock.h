// A lock between processes that ends with its holder, however that ends.
//
// Left out  waiting for a lock; locks on network file systems that do not know them.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace tact {

class FileLock {
  public:
    explicit FileLock(int file) : file_(file) {}
    FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    FileLock& operator=(FileLock&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~FileLock();

  private:
    int file_;
};

// Makes the file if need be. None: someone else holds it, or there can be no such file.
std::optional<FileLock> try_lock(const std::filesystem::path& path);

}  // namespace tact
