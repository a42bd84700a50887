// Controllers that the kernel seems to have: hidapi lists, opens, reads and writes them, and what
// it writes is kept.
//
// Source    umockdev: a sysfs and device nodes of its own, for programs run by umockdev-wrapper
// Left out  input reports that come by themselves; that two writes of one program are in turn.
#pragma once

#include <umockdev.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
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
    explicit MockBench(std::vector<MockPad> pads);
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
    struct Held {
        UMockdevIoctlClient* client = nullptr;
        Packet packet;
    };

    struct Plugged {
        MockBench* bench = nullptr;
        MockPad pad;
        UMockdevIoctlBase* handler = nullptr;
        std::vector<Written> written;
        bool gone = false;
        int refuses = 0;
        bool holds = false;
        std::vector<Held> held{};
    };

    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plugged);
    static gboolean let_all_go(gpointer bench);
    static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer plugged);

    void add(Plugged& plugged);
    void with(const std::string& node, const std::function<void(Plugged&)>& change);
    static void take(Plugged& plugged, UMockdevIoctlClient* client, const Packet& packet);
    void answer(const Plugged& plugged, const Packet& packet);

    UMockdevTestbed* testbed_ = nullptr;
    GMainContext* context_ = nullptr;
    GMainLoop* loop_ = nullptr;
    mutable std::mutex mutex_;  // guards what was written and what is gone
    std::deque<Plugged> plugged_;
    std::thread thread_;
};

}  // namespace tact
