#include "app/session/session.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace file_lock_test {

using namespace tact;
namespace fs = std::filesystem;

TEST_CASE("lock: one holder at a time, and free again when the holder goes") {
    std::string name = (fs::temp_directory_path() / "lock-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    const fs::path file = fs::path(name) / "lock";
    {
        std::optional<FileLock> first = try_lock(file);
        REQUIRE(first.has_value());
        CHECK_FALSE(try_lock(file).has_value());
        const FileLock moved = *std::move(first);
        first.reset();
        CHECK_FALSE(try_lock(file).has_value());
    }
    CHECK(try_lock(file).has_value());
    fs::remove_all(name);
}

TEST_CASE("lock: where there can be no file there is no lock") {
    CHECK_FALSE(try_lock("/nowhere/at/all/lock").has_value());
}

}  // namespace file_lock_test
