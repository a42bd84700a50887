// A controller continues with what it was told last: it is brought to rest after every ending that
// leaves somebody to do so.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>
#include <optional>

#include "devices/device/halt.h"
#include "devices/hid/patient_port.h"
#include "tests/support/fake_pad.h"

namespace hid_rest_test {

using namespace tact;
using namespace tact::fake_pad;

namespace {

// A pad that may refuse its next packets, or keep a write for as long as it likes.
struct BadPad {
    std::shared_ptr<FakePad> pad = std::make_shared<FakePad>();
    std::atomic<int> refuses = 0;
    std::mutex mutex;
    std::condition_variable changed;
    bool hangs = false;

    bool write(const HidPort& port, std::span<const std::uint8_t> packet) {
        {
            std::unique_lock lock(mutex);
            changed.wait(lock, [this] { return !hangs; });
        }
        if (refuses.load() > 0) {
            --refuses;
            return false;
        }
        return port.write(packet);
    }
    void set_hangs(bool value) {
        const std::lock_guard lock(mutex);
        hangs = value;
        changed.notify_all();
    }
};

HidPort port_of_bad(const std::shared_ptr<BadPad>& bad) {
    HidPort port = port_of(bad->pad);
    port.write = [bad, plain = port](std::span<const std::uint8_t> packet) {
        return bad->write(plain, packet);
    };
    return port;
}

std::unique_ptr<HidDevice> device_on_bad(const std::shared_ptr<BadPad>& bad, ActuatorKind kind) {
    const HidActuator which = actuator(kind, HidBus::usb);
    HidPorts ports;
    ports.list = [which] { return std::vector{which}; };
    ports.may_be_opened = [](const HidActuator&) -> Expected<Done> { return Done{}; };
    ports.open = [bad](const std::string&) { return port_of_bad(bad); };
    ports.claim = [](const HidActuator&) { return ActuatorLock(); };
    return std::make_unique<HidDevice>(which, ports);
}

bool is_at_rest(const BadPad& bad) {
    const auto packets = bad.pad->taken();
    const Packet neutral = switch_rumble(0, {});
    return packets.size() > kNeutralPackets &&
           std::all_of(packets.end() - kNeutralPackets, packets.end(), [&](const Packet& p) {
               return p[0] == 0x10 &&
                      std::equal(p.begin() + 2, p.end(), neutral.begin() + 2, neutral.end());
           });
}

// A write is waited for by seconds.
template <class Condition>
bool in_time(const Condition& condition) {
    for (int k = 0; k < 6; ++k) {
        if (soon(condition)) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("hid rest: refused packets end a play, and neutral ones follow once they are taken" *
          doctest::test_suite("long")) {
    for (const int refused : {2, 3, 8, 40}) {
        CAPTURE(refused);
        const auto bad = std::make_shared<BadPad>();
        const auto device = device_on_bad(bad, ActuatorKind::switch_pro);
        REQUIRE(device->play(tone(0.5), true));
        REQUIRE(soon([&] { return bad->pad->taken().size() > 10; }));
        bad->refuses = refused;
        CHECK(ended(*device));
        CHECK(soon([&] { return is_at_rest(*bad); }));
        CHECK_FALSE(device->status().trouble.empty());
    }
}

TEST_CASE("hid rest: before a program ends without its destructors, a pad is told to be still" *
          doctest::test_suite("long")) {
    const auto bad = std::make_shared<BadPad>();
    const auto device = device_on_bad(bad, ActuatorKind::switch_pro);
    REQUIRE(device->play(tone(0.5), true));
    REQUIRE(soon([&] { return bad->pad->taken().size() > 10; }));
    rest_all();
    CHECK(ended(*device));
    CHECK(soon([&] { return is_at_rest(*bad); }));
    CHECK(device->status().trouble.ends_with(kHalted));
}

TEST_CASE("hid rest: a write that does not return holds up neither a stop nor the end" *
          doctest::test_suite("long")) {
    const auto bad = std::make_shared<BadPad>();
    auto device = device_on_bad(bad, ActuatorKind::switch_pro);
    REQUIRE(device->play(tone(0.5), true));
    REQUIRE(soon([&] { return bad->pad->taken().size() > 10; }));
    bad->set_hangs(true);
    device->stop();
    CHECK(in_time([&] { return !device->status().playing; }));
    auto closed = std::async(std::launch::async, [&device] { device.reset(); });
    CHECK(closed.wait_for(std::chrono::seconds(60)) == std::future_status::ready);
    bad->set_hangs(false);  // in the end the driver comes back, to nobody
    closed.wait();
}

TEST_CASE("hid rest: a write that was late and came back is followed by neutral packets" *
          doctest::test_suite("long")) {
    const auto bad = std::make_shared<BadPad>();
    const auto device = device_on_bad(bad, ActuatorKind::switch_pro);
    REQUIRE(device->play(tone(0.5), true));
    REQUIRE(soon([&] { return bad->pad->taken().size() > 10; }));
    bad->set_hangs(true);
    // It ends by itself: the pad takes no packet.
    CHECK(in_time([&] { return !device->status().playing; }));
    bad->set_hangs(false);
    CHECK(soon([&] { return is_at_rest(*bad); }));
}

TEST_CASE("hid rest: a port with patience says what was taken, and when it was not in time") {
    std::mutex mutex;
    std::condition_variable changed;
    bool hangs = false;
    int taken = 0;
    HidPort port;
    port.write = [&](std::span<const std::uint8_t>) {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return !hangs; });
        ++taken;
        return true;
    };
    const auto set_hangs = [&](bool value) {
        const std::lock_guard lock(mutex);
        hangs = value;
        changed.notify_all();
    };
    const std::vector<std::uint8_t> packet{1, 2};
    {
        const HidPort patient = patient_port(port, std::chrono::milliseconds(20));
        CHECK(patient.write(packet));
        set_hangs(true);
        CHECK_FALSE(patient.write(packet));
        CHECK_FALSE(patient.write(packet));  // while the one before is still under way
        set_hangs(false);
        CHECK(soon([&] { return patient.write(packet); }));
    }
    CHECK(taken >= 3);
}

}  // namespace hid_rest_test
