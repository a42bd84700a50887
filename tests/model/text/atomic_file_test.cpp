#include "model/text/atomic_file.h"

#include <doctest/doctest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "tests/support/no_more_than.h"
#include "tests/support/temporary_folder.h"

namespace atomic_file_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

unsigned mode_of(const fs::path& path) {
    struct stat about {};
    REQUIRE(::stat(path.c_str(), &about) == 0);
    return about.st_mode & 07777;
}

}  // namespace

TEST_CASE("atomic file: what is written is what is read") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "\u9707\u52a8 and blanks.json";
    const std::string bytes("a\0\xFF\n", 4);
    REQUIRE(write_atomically(file, bytes));
    CHECK(*read_text_file(file) == bytes);
    REQUIRE(write_atomically(file, ""));
    CHECK(read_text_file(file)->empty());
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE("atomic file: pieces become one file, and only by commit") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("old.csv", "old");
    {
        auto abandoned = AtomicFile::open(file);
        REQUIRE(abandoned);
        REQUIRE(abandoned->append("half of it"));
        CHECK(bytes_of(file) == "old");
        CHECK(file_count(folder.path) == 2);
    }
    CHECK(bytes_of(file) == "old");
    CHECK(file_count(folder.path) == 1);

    auto complete = AtomicFile::open(file);
    REQUIRE(complete->append("one,"));
    REQUIRE(complete->append("two"));
    REQUIRE(complete->commit());
    CHECK(bytes_of(file) == "one,two");
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE(
    "atomic file: when the disk is full, the old file stays whole and nothing is left behind") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("set.json", "old");
    const std::string much(100'000, 'x');
    const auto written = [&] {
        const NoMoreThan limit(1000);
        return write_atomically(file, much);
    }();
    REQUIRE_FALSE(written);
    CHECK(written.error().message == file.string() + ": cannot be written: File too large");
    CHECK(bytes_of(file) == "old");
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE(
    "atomic file: what ends the program in between removes what is not finished, and no more") {
    const TemporaryFolder folder;
    REQUIRE(write_atomically(folder.path / "old", "old"));
    auto file = AtomicFile::open(folder.path / "old");
    REQUIRE(file);
    REQUIRE(file->append("new"));
    auto finished = AtomicFile::open(folder.path / "finished");
    REQUIRE(finished);
    REQUIRE(finished->commit());
    CHECK(file_count(folder.path) == 3);
    remove_unfinished_files();
    CHECK(file_count(folder.path) == 2);
    CHECK(*read_text_file(folder.path / "old") == "old");
    CHECK_FALSE(file->commit());  // it is gone: nothing of it may come into place
    CHECK(*read_text_file(folder.path / "old") == "old");
    CHECK(file_count(folder.path) == 2);
}

TEST_CASE("atomic file: a device is written to, not replaced") {
    const auto written = write_atomically("/dev/full", "x");
    REQUIRE_FALSE(written);
    CHECK(written.error().message == "/dev/full: cannot be written: No space left on device");
    CHECK(write_atomically("/dev/null", "x"));
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE(
    "atomic file: where there is no way to write, the sentence gives the path and the reason") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "old");
    const auto fault = [](const fs::path& path) {
        const auto written = write_atomically(path, "new");
        REQUIRE_FALSE(written);
        return written.error().message;
    };
    CHECK(fault(file / "below") ==
          (file / "below").string() + ": cannot be written: Not a directory");
    CHECK(contains(fault(folder.path / "no" / "such"), "No such file or directory"));
    CHECK(contains(fault(folder.path), "Is a directory"));
    CHECK_FALSE(write_atomically("/proc/none.json", "x"));
    if (::geteuid() != 0) {  // permissions do not bind root
        fs::permissions(file, fs::perms::owner_read);
        CHECK(contains(fault(file), "Permission denied"));
        fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
        CHECK(contains(fault(folder.path / "new"), "Permission denied"));
        fs::permissions(folder.path, fs::perms::owner_all);
    }
    CHECK(bytes_of(file) == "old");
}

TEST_CASE("atomic file: a link stays a link, and its target is what changes") {
    const TemporaryFolder folder;
    const fs::path target = folder.write("real/target.json", "old");
    fs::create_symlink("real/target.json", folder.path / "link");
    fs::create_symlink("link", folder.path / "link to link");
    REQUIRE(write_atomically(folder.path / "link to link", "new"));
    CHECK(bytes_of(target) == "new");
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(fs::is_symlink(folder.path / "link to link"));

    fs::create_symlink(folder.path / "real" / "new.json", folder.path / "dangling");
    REQUIRE(write_atomically(folder.path / "dangling", "made"));
    CHECK(bytes_of(folder.path / "real" / "new.json") == "made");

    fs::create_symlink("circle", folder.path / "circle");
    const auto circle = write_atomically(folder.path / "circle", "x");
    REQUIRE_FALSE(circle);
    CHECK(contains(circle.error().message, "symbolic links"));
}

TEST_CASE("atomic file: the mode of a file is kept, a new one gets the usual mode") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("shared", "old");
    ::chmod(file.c_str(), 0640);
    REQUIRE(write_atomically(file, "new"));
    CHECK(mode_of(file) == 0640);

    const fs::path usual = folder.write("by the system", "");
    REQUIRE(write_atomically(folder.path / "by us", ""));
    CHECK(mode_of(folder.path / "by us") == mode_of(usual));
}

TEST_CASE("atomic file: reading refuses what is no file, by name") {
    const TemporaryFolder folder;
    const auto missing = read_text_file(folder.path / "none.json");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message ==
          (folder.path / "none.json").string() + ": there is no such file");
    const auto is_folder = read_text_file(folder.path);
    REQUIRE_FALSE(is_folder);
    CHECK(is_folder.error().message == folder.path.string() + ": is a folder, expected a file");

    const fs::path huge = folder.write("huge", "");
    fs::resize_file(huge, kMaxFileBytes + 1);  // sparse
    const auto too_long = read_text_file(huge);
    REQUIRE_FALSE(too_long);
    CHECK(too_long.error().message == huge.string() + ": expected at most 536,870,912 bytes");
}

TEST_CASE(
    "atomic file: only regular files are read or written on; a pipe, a socket or a device is none, "
    "at once") {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path / "pipe.json";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);  // reading would wait for a writer for ever
    sockaddr_un address{AF_UNIX, "socket.json"};
    const fs::path before = fs::current_path();
    const int end = ::socket(AF_UNIX, SOCK_STREAM, 0);
    fs::current_path(folder.path);
    REQUIRE(::bind(end, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    fs::current_path(before);
    fs::create_symlink("/dev/zero", folder.path / "endless.json");
    const auto fault = [&](const char* name) {
        const auto read = read_text_file(folder.path / name);
        const auto size = readable_size(folder.path / name);
        REQUIRE_FALSE(read);
        REQUIRE_FALSE(size);
        CHECK(size.error().message == read.error().message);
        for (const bool make : {false, true}) {
            const auto own = open_alone(folder.path / name, make);
            REQUIRE_FALSE(own);
            CHECK(own.error().message == read.error().message);
        }
        return read.error().message.substr((folder.path / name).string().size());
    };
    CHECK(fault("pipe.json") == ": is a pipe, expected a file");
    CHECK(fault("socket.json") == ": is a socket, expected a file");
    CHECK(fault("endless.json") == ": is a device, expected a file");
    ::close(end);

    const fs::path some = folder.write("some", "12345");
    CHECK(*read_text_file(some, 5) == "12345");
    CHECK(contains(read_text_file(some, 4).error().message, "at most 4 bytes"));
    CHECK(read_text_file("/proc/self/status"));  // a regular file that says it has 0 bytes
    CHECK_FALSE(read_text_file("/proc/self/status", 4));
}

TEST_CASE("atomic file: one that grows has one program at a time, and is made only on request") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "grows";
    CHECK(contains(open_alone(file, false).error().message, "grows: cannot be written: No such"));
    auto first = open_alone(file, true);
    REQUIRE(first);
    CHECK_FALSE(first->write("one"));
    CHECK(open_alone(file, true).error().message ==
          file.string() + ": another tactspace is writing it, expected to be alone");
    CHECK_FALSE(first->close());
    auto second = open_alone(file, false);
    REQUIRE(second);
    CHECK_FALSE(second->write(" two"));
    CHECK_FALSE(second->close());
    CHECK(bytes_of(file) == "one two");
}

TEST_CASE("atomic file: what a killed program left is removed a day later, and nothing else") {
    const TemporaryFolder folder;
    const std::string dead = ".tactspace-4194305-";  // Linux numbers processes up to 4194304
    const auto of_hours_ago = [&](const std::string& name, int hours) {
        const fs::path file = folder.write(name, "half");
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
        return file;
    };
    const auto old = [&](const std::string& name) { return of_hours_ago(name, 25); };
    const fs::path left = old(dead + "0.part");
    const std::vector<fs::path> kept{
        old(".tactspace-" + std::to_string(::getpid()) + "-0.part"),
        of_hours_ago(dead + "1.part", 1),  // on another machine, perhaps
        old(".tactspace-4194305.part"),
        old(".tactspace--1-1.part"),
        old(dead + "2.json"),
        old("tactspace-4194305-3.part")};
    fs::create_directory(folder.path / (dead + "4.part"));
    remove_abandoned_files(folder.path);
    CHECK_FALSE(fs::exists(left));
    for (const fs::path& file : kept) CHECK_MESSAGE(fs::exists(file), file.string());
    CHECK(fs::exists(folder.path / (dead + "4.part")));
    remove_abandoned_files(folder.path / "none");  // no folder, nothing to do
}

TEST_CASE("atomic file: a file that is being made is nobody's who may not read the old one") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("secret", "old");
    ::chmod(file.c_str(), 0600);
    auto made = AtomicFile::open(file);
    REQUIRE(made);
    for (const auto& entry : fs::directory_iterator(folder.path)) {
        CHECK((mode_of(entry.path()) & 0077) == 0);
    }
}

}  // namespace atomic_file_test
