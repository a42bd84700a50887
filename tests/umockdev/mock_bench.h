// Controllers that the kernel seems to have: hidapi lists, opens, reads and writes them, and what
// it writes is kept.
//
// Source    umockdev: a sysfs and device nodes of its own, for programs run by umockdev-wrapper
// Left out  input reports that come by themselves; that two writes of one program are in turn.
#pragma once

#include <umockdev.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "devices/rumble/rumble_packets.h"

namespace tact {

struct MockPad {
    std::string node;  // "hidraw0"
    bool is_bluetooth = false;
    unsigned vendor = 0;
    unsigned product = 0;
    std::string name;
    std::string driver;  // that has it; empty: none
    Packet descriptor{0x05, 0x01, 0x09, 0x05, 0xA1, 0x01, 0xC0};
    Packet feature{};            // the answer to any feature report
    bool answers_switch = true;  // 80 xx and subcommands
};

struct Written {
    Packet packet;
    std::chrono::steady_clock::time_point at;
};

class MockBench {
  public:
    explicit MockBench(const std::vector<MockPad>& pads);
    ~MockBench();
    MockBench(const MockBench&) = delete;
    MockBench& operator=(const MockBench&) = delete;

    // What has been written to a node so far.
    std::vector<Written> written(const std::string& node) const;

    void unplug(const std::string& node);

    // The next `count` reports are an error, EIO.
    void refuse(const std::string& node, int count);
    bool has_refused(const std::string& node);  // all of them
    // From now on a write does not come back until it is let go; its report counts as taken then.
    void hold(const std::string& node);
    void let_go(const std::string& node);

  private:
    struct Plugged;
    struct Desk;
    struct Line;

    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer line);
    static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer line);

    void connect(Plugged& plugged);
    void with(const std::string& node, const std::function<void(Plugged&)>& change) const;
    static void take(const Desk& desk, Plugged& plugged, UMockdevIoctlClient* client,
                     const Packet& packet);
    static void answer(const Desk& desk, const Plugged& plugged, const Packet& packet);

    // The thread that answers is the testbed's. It is never joined, and answers writes that were on
    // their way when the bench ended: what it needs lives as long as its handlers.
    std::shared_ptr<Desk> desk_;
};

}  // namespace tact
