#include "devices/device/actuator_lock.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace actuator_lock_test {

using namespace tact;

namespace {

// Its locks lie apart from those of programs that run.
struct RuntimeFolder {
    TemporaryFolder folder;
    std::optional<std::string> before;

    RuntimeFolder() {
        if (const char* now = std::getenv("XDG_RUNTIME_DIR")) before = now;
        setenv("XDG_RUNTIME_DIR", folder.path.c_str(), 1);
    }
    ~RuntimeFolder() {
        if (before) setenv("XDG_RUNTIME_DIR", before->c_str(), 1);
        if (!before) unsetenv("XDG_RUNTIME_DIR");
    }
};

}  // namespace

TEST_CASE("actuator lock: an actuator has one program at a time, and its neighbour another") {
    const RuntimeFolder folder;
    {
        const Expected<ActuatorLock> first = ActuatorLock::of("alsa:card 0", "the card");
        REQUIRE(first);
        const Expected<ActuatorLock> second = ActuatorLock::of("alsa:card 0", "the card");
        REQUIRE_FALSE(second);
        CHECK(second.error().message ==
              "another tactspace plays on the card: stop it there, as the two would add up");
        CHECK(ActuatorLock::of("alsa:card 1", "its neighbour"));
    }
    CHECK(ActuatorLock::of("alsa:card 0", "the card"));
}

TEST_CASE("actuator lock: names that are alike, or long, are not those of one actuator") {
    const RuntimeFolder folder;
    const std::string long_name(300, 'x');
    for (const auto& [one, other] :
         {std::pair<std::string, std::string>{"server a.b 1", "server a_b 1"},
          {long_name + " 1", long_name + " 2"}}) {
        CAPTURE(one);
        const Expected<ActuatorLock> first = ActuatorLock::of(one, "the first");
        REQUIRE(first);
        CHECK(ActuatorLock::of(other, "the other"));
        CHECK_FALSE(ActuatorLock::of(one, "the first"));
    }
}

TEST_CASE("actuator lock: moved on, it is held until its new place ends") {
    const RuntimeFolder folder;
    ActuatorLock kept;
    {
        Expected<ActuatorLock> first = ActuatorLock::of("hid:057e:2006", "the pad");
        REQUIRE(first);
        kept = *std::move(first);
    }
    CHECK_FALSE(ActuatorLock::of("hid:057e:2006", "the pad"));
    kept = {};
    CHECK(ActuatorLock::of("hid:057e:2006", "the pad"));
}

}  // namespace actuator_lock_test
