// Files as the system has them, where the C++ library has no word for it: opened by nobody else,
// locked, cut, brought to the disk, with an owner and a mode.
//
// Output    failures as codes of std::generic_category(), whose message() people can read; a code
//           that is given is cleared on success
// Left out  what a file is for: model/text/atomic_file.h
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace tact {

enum class FileKind { file, folder, pipe, socket, device };

struct FileFacts {
    FileKind kind = FileKind::file;
    std::uint64_t bytes = 0;
};

enum class FileUse {
    read,            // what is there; answers at once, whatever it is
    write_to,        // a device or a pipe that is there
    make,            // a new file: one that is there is an error
    extend,          // a file that is there: read, and written on at its end
    extend_or_make,  // and one that is not
};

// Closed when it goes.
class OpenFile {
  public:
    OpenFile() = default;
    // `mode` is that of a new file, less what the umask takes.
    OpenFile(const std::filesystem::path& path, FileUse use, unsigned mode, std::error_code& fault);
    OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~OpenFile();

    bool is_open() const { return descriptor_ >= 0; }
    FileFacts facts(std::error_code& fault) const;

    // The next bytes, at most `size`; 0: the end, or a fault.
    std::size_t read(char* bytes, std::size_t size, std::error_code& fault);
    // The bytes at a place, at most `size`: fewer at the end of the file, or where it cannot be
    // read.
    std::size_t read_at(std::uint64_t place, void* bytes, std::size_t size) const;
    // All of the bytes, or a fault.
    std::error_code write(std::string_view bytes);
    std::error_code cut(std::uint64_t bytes);  // what is behind them is gone
    std::error_code sync();                    // all that there is to know of the file
    std::error_code sync_content();            // as much of it as reading it needs
    std::error_code close();                   // writing may fail as late as here

    // False: another holds it. A file system without locks must not keep anyone from working.
    bool lock();
    // The owner, as far as this user may give files away, and the mode of another file.
    std::error_code take_owner_and_mode_of(const std::filesystem::path& other);

  private:
    int descriptor_ = -1;
};

// Links are followed.
FileFacts facts_of(const std::filesystem::path& path, std::error_code& fault);

// Why a file may not be written to, or nothing.
std::error_code writing_fault(const std::filesystem::path& path);

// In one step: whoever reads the name finds the one or the other.
std::error_code put_in_place_of(const std::filesystem::path& file,
                                const std::filesystem::path& old);

// Removes a file by its name. Safe in a handler of signals (signal-safety(7)).
void remove_at_once(const char* file) noexcept;

// A regular file of this user, no link, that nobody has written to for this long.
bool is_own_and_older_than(const std::filesystem::path& file, std::int64_t seconds);

// A new file is safe from a power cut only when its folder is. A failure is nobody's: what is lost
// then is the name, not the file.
void sync_folder(const std::filesystem::path& folder);

}  // namespace tact
