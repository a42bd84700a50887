#include "tests/umockdev/mock_bench.h"

#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>
#include <mutex>
#include <utility>

namespace tact {

namespace {

std::string hexadecimal(const Packet& bytes) {
    std::string text;
    char two[3];
    for (const std::uint8_t byte : bytes) {
        std::snprintf(two, sizeof two, "%02X", byte);
        text += two;
    }
    return text;
}

// In sysfs; the last part is the device's name on its bus, and so its own.
std::string folder(const std::string& node) {
    return std::string("/devices/virtual/pad/0000:0000:0000.000") + node.back();
}

// As a recording of a real one has it: the hid device, and the node below it.
std::string description(const MockPad& pad) {
    char id[64];
    std::snprintf(id, sizeof id, "%04X:%08X:%08X", pad.is_bluetooth ? 5U : 3U, pad.vendor,
                  pad.product);
    const std::string hid = folder(pad.node);
    std::string text = "P: " + hid + "\nE: SUBSYSTEM=hid\nE: HID_ID=" + id +
                       "\nE: HID_NAME=" + pad.name + "\nE: HID_UNIQ=98:b6:e9:00:00:0" +
                       pad.node.back() + "\nH: report_descriptor=" + hexadecimal(pad.descriptor);
    if (!pad.driver.empty()) text += "\nL: driver=../../../../bus/hid/drivers/" + pad.driver;
    text += "\n\nP: " + hid + "/hidraw/" + pad.node + "\nN: " + pad.node +
            "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/" + pad.node + "\nL: device=../../../" +
            hid.substr(hid.rfind('/') + 1) + "\n\n";
    return text;
}

void require(bool condition, const char* what) {
    if (condition) return;
    std::cerr << "umockdev: " << what << "\n";
    std::abort();
}

void put(UMockdevIoctlData* argument, std::size_t offset, const void* bytes, std::size_t size) {
    Packet copy(size);
    std::memcpy(copy.data(), bytes, size);
    umockdev_ioctl_data_update(argument, offset, copy.data(), static_cast<int>(size));
}

}  // namespace

struct MockBench::Plugged {
    struct Held {
        UMockdevIoctlClient* client = nullptr;
        Packet packet;
    };

    MockPad pad;
    UMockdevIoctlBase* handler = nullptr;
    std::vector<Written> written{};
    bool gone = false;
    int refuses = 0;
    bool holds = false;
    std::vector<Held> held{};
};

struct MockBench::Desk {
    std::mutex mutex;  // guards all below
    UMockdevTestbed* testbed = nullptr;
    std::deque<Plugged> plugged{};
};

// What a handler is given: its node, and what keeps that alive.
struct MockBench::Line {
    std::shared_ptr<Desk> desk;
    Plugged* plugged = nullptr;
};

MockBench::MockBench(const std::vector<MockPad>& pads) : desk_(std::make_shared<Desk>()) {
    desk_->testbed = umockdev_testbed_new();
    for (const MockPad& pad : pads) desk_->plugged.push_back({pad});
    for (Plugged& plugged : desk_->plugged) connect(plugged);
}

MockBench::~MockBench() {
    const std::lock_guard lock(desk_->mutex);
    for (Plugged& plugged : desk_->plugged) {
        plugged.gone = true;
        for (const Plugged::Held& held : plugged.held) {
            umockdev_ioctl_client_complete(held.client, -1, ENODEV);
            g_object_unref(held.client);
        }
        umockdev_testbed_detach_ioctl(desk_->testbed, ("/dev/" + plugged.pad.node).c_str(),
                                      nullptr);
        g_object_unref(plugged.handler);
    }
    g_object_unref(desk_->testbed);
}

void MockBench::connect(Plugged& plugged) {
    require(
        umockdev_testbed_add_from_string(desk_->testbed, description(plugged.pad).c_str(), nullptr),
        "the description is not understood");
    plugged.handler = umockdev_ioctl_base_new();
    const auto forget = [](gpointer line, GClosure*) { delete static_cast<Line*>(line); };
    for (const auto& [signal, answers] : {std::pair{"handle-ioctl", G_CALLBACK(on_ioctl)},
                                          {"handle-write", G_CALLBACK(on_write)}}) {
        g_signal_connect_data(plugged.handler, signal, answers, new Line{desk_, &plugged}, forget,
                              GConnectFlags{});
    }
    require(umockdev_testbed_attach_ioctl(desk_->testbed, ("/dev/" + plugged.pad.node).c_str(),
                                          plugged.handler, nullptr),
            "no handler can be attached");
}

gboolean MockBench::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer line) {
    const Plugged& plugged = *static_cast<const Line*>(line)->plugged;
    const unsigned long request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    const std::size_t size = _IOC_SIZE(request);
    UMockdevIoctlData* const target = umockdev_ioctl_data_resolve(argument, 0, size, nullptr);
    long result = -1;
    int fault = ENOTTY;
    const Packet& descriptor = plugged.pad.descriptor;
    if (target != nullptr && request == HIDIOCGRDESCSIZE) {
        const int length = static_cast<int>(descriptor.size());
        put(target, 0, &length, sizeof length);
        result = 0;
    } else if (target != nullptr && request == HIDIOCGRDESC) {
        put(target, sizeof(__u32), descriptor.data(), descriptor.size());
        result = 0;
    } else if (target != nullptr && _IOC_TYPE(request) == 'H' && _IOC_NR(request) == 7) {
        const std::size_t length = std::min(size, plugged.pad.feature.size());
        put(target, 0, plugged.pad.feature.data(), length);
        result = static_cast<long>(length);
    }
    umockdev_ioctl_client_complete(client, result, result < 0 ? fault : 0);
    if (target != nullptr) umockdev_ioctl_data_unref(target);
    return TRUE;
}

gboolean MockBench::on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer line) {
    const auto& [desk, of] = *static_cast<const Line*>(line);
    Plugged& plugged = *of;
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    const Packet packet(argument->data, argument->data + argument->data_len);
    const std::lock_guard lock(desk->mutex);
    if (plugged.gone) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
    } else if (plugged.refuses > 0) {
        --plugged.refuses;
        umockdev_ioctl_client_complete(client, -1, EIO);
    } else if (plugged.holds) {
        plugged.held.push_back({UMOCKDEV_IOCTL_CLIENT(g_object_ref(client)), packet});
    } else {
        take(*desk, plugged, client, packet);
    }
    return TRUE;
}

void MockBench::take(const Desk& desk, Plugged& plugged, UMockdevIoctlClient* client,
                     const Packet& packet) {
    plugged.written.push_back({packet, std::chrono::steady_clock::now()});
    if (plugged.pad.answers_switch) answer(desk, plugged, packet);
    umockdev_ioctl_client_complete(client, static_cast<long>(packet.size()), 0);
}

void MockBench::with(const std::string& node, const std::function<void(Plugged&)>& change) const {
    const std::lock_guard lock(desk_->mutex);
    for (Plugged& plugged : desk_->plugged) {
        if (plugged.pad.node == node) change(plugged);
    }
}

void MockBench::refuse(const std::string& node, int count) {
    with(node, [count](Plugged& plugged) { plugged.refuses = count; });
}

bool MockBench::has_refused(const std::string& node) {
    bool all = false;
    with(node, [&all](const Plugged& plugged) { all = plugged.refuses == 0; });
    return all;
}

void MockBench::hold(const std::string& node) {
    with(node, [](Plugged& plugged) { plugged.holds = true; });
}

void MockBench::let_go(const std::string& node) {
    with(node, [this](Plugged& plugged) {
        plugged.holds = false;
        for (const Plugged::Held& held : plugged.held) {
            take(*desk_, plugged, held.client, held.packet);
            g_object_unref(held.client);
        }
        plugged.held.clear();
    });
}

// One report at a time: the node is a stream here, without borders between them.
void MockBench::answer(const Desk& desk, const Plugged& plugged, const Packet& packet) {
    Packet report;
    if (packet.size() > 1 && packet[0] == 0x80 && packet[1] != 0x04) report = {0x81, packet[1]};
    if (packet.size() > 10 && packet[0] == 0x01) {
        report = Packet(49);
        report[0] = 0x21;
        report[13] = 0x80;
        report[14] = packet[10];
    }
    if (report.empty()) return;
    const int node =
        umockdev_testbed_get_dev_fd(desk.testbed, ("/dev/" + plugged.pad.node).c_str());
    require(write(node, report.data(), report.size()) == std::ssize(report), "no answer is taken");
}

std::vector<Written> MockBench::written(const std::string& node) const {
    std::vector<Written> all;
    with(node, [&all](const Plugged& plugged) { all = plugged.written; });
    return all;
}

void MockBench::unplug(const std::string& node) {
    with(node, [](Plugged& plugged) { plugged.gone = true; });
    const std::string hid = "/sys" + folder(node);
    umockdev_testbed_remove_device(desk_->testbed, (hid + "/hidraw/" + node).c_str());
    umockdev_testbed_remove_device(desk_->testbed, hid.c_str());
}

}  // namespace tact
