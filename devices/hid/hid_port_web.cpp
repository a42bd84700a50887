// Controllers of a page, by WebHID. A browser tells of those that its person has allowed, on the
// page's own thread alone: what a controller's thread asks is done there, and answers come back
// from there. A report counts as taken once the browser has it; one that it could not send is told
// by the next.
//
// Source    WebHID of the WICG
// Left out  descriptors and serial numbers, which a page is not told; two pages that play on one
//           controller; browsers without WebHID (Firefox, Safari); pages without threads
#include <emscripten.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>

#include "devices/device/halt.h"
#include "devices/hid/hid_port.h"
#include "model/system/process.h"

// In web_hid.js.
extern "C" {
int web_hid_is_there();
void web_hid_watch();
char* web_hid_list();  // to be freed
void web_hid_ask(const std::uint16_t* kinds, int count);
int web_hid_has(const char* path);
void web_hid_open(int number, const char* path);
void web_hid_close(int number);
int web_hid_write(int number, const std::uint8_t* report, int size);
void web_hid_feature(int number, int report);
void web_hid_rest_with(int number, const std::uint8_t* report, int size);
void web_hid_rest();
}

namespace tact {

namespace {

constexpr std::chrono::seconds kAnswered{5};  // longest time for an open or a feature report
constexpr std::size_t kKeptReports = 16;      // of those that came and nobody has read

// What came of one port, on the page's thread.
struct WebPort {
    std::mutex mutex;  // guards the rest
    std::condition_variable changed;
    std::optional<bool> is_open;
    std::deque<Packet> reports;
    std::optional<Packet> feature;
};

struct WebPorts {
    std::mutex mutex;  // guards the rest
    std::map<int, std::shared_ptr<WebPort>> open;
    int last = 0;
    std::function<void()> changed;
};

// JavaScript calls by names, which have no room for an argument of ours.
WebPorts& web_ports() {
    static WebPorts& ports = *new WebPorts;
    return ports;
}

template <class Take>
void take_at_port(int number, const Take& take) {
    std::shared_ptr<WebPort> port;
    {
        const std::lock_guard lock(web_ports().mutex);
        const auto found = web_ports().open.find(number);
        if (found == web_ports().open.end()) return;
        port = found->second;
    }
    const std::lock_guard lock(port->mutex);
    take(*port);
    port->changed.notify_all();
}

// An open port, which closes with the last who holds it.
struct OpenWebPort {
    int number = 0;
    std::shared_ptr<WebPort> port = std::make_shared<WebPort>();

    OpenWebPort() {
        const std::lock_guard lock(web_ports().mutex);
        number = ++web_ports().last;
        web_ports().open[number] = port;
    }
    ~OpenWebPort() {
        web_hid_close(number);
        const std::lock_guard lock(web_ports().mutex);
        web_ports().open.erase(number);
    }
    OpenWebPort(const OpenWebPort&) = delete;
    OpenWebPort& operator=(const OpenWebPort&) = delete;

    bool opens(const std::string& path) const {
        web_hid_open(number, path.c_str());
        std::unique_lock lock(port->mutex);
        port->changed.wait_for(lock, kAnswered, [this] { return port->is_open.has_value(); });
        return port->is_open.value_or(false);
    }

    Packet read(int wait_ms) const {
        std::unique_lock lock(port->mutex);
        const std::chrono::milliseconds patience(wait_ms);
        port->changed.wait_for(lock, patience, [this] { return !port->reports.empty(); });
        if (port->reports.empty()) return {};
        Packet report = std::move(port->reports.front());
        port->reports.pop_front();
        return report;
    }

    Packet feature(int report, std::size_t bytes) const {
        {
            const std::lock_guard lock(port->mutex);
            port->feature.reset();
        }
        web_hid_feature(number, report);
        std::unique_lock lock(port->mutex);
        port->changed.wait_for(lock, kAnswered, [this] { return port->feature.has_value(); });
        Packet answer = port->feature.value_or(Packet());
        // Browsers differ in whether the number of the report comes before it.
        if (!answer.empty() && answer.size() <= bytes) {
            answer.insert(answer.begin(), static_cast<std::uint8_t>(report));
        }
        return answer;
    }
};

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE void web_hid_opened(int number, int is_open) {
    take_at_port(number, [&](WebPort& port) { port.is_open = is_open != 0; });
}

EMSCRIPTEN_KEEPALIVE void web_hid_came(int number, const std::uint8_t* report, int size) {
    take_at_port(number, [&](WebPort& port) {
        if (port.reports.size() == kKeptReports) port.reports.pop_front();
        port.reports.emplace_back(report, report + size);
    });
}

EMSCRIPTEN_KEEPALIVE void web_hid_feature_came(int number, const std::uint8_t* report, int size) {
    take_at_port(number, [&](WebPort& port) { port.feature.emplace(report, report + size); });
}

EMSCRIPTEN_KEEPALIVE void web_hid_changed() {
    std::function<void()> changed;
    {
        const std::lock_guard lock(web_ports().mutex);
        changed = web_ports().changed;
    }
    if (changed) changed();
}
}

Expected<HidPort> open_hid_port(const std::string& path) {
    call_before_halts(web_hid_rest);
    const auto open = std::make_shared<OpenWebPort>();
    if (!open->opens(path)) return Error{path + ": cannot be opened; is it in use, or just gone?"};
    HidPort port;
    port.write = [open](std::span<const std::uint8_t> report) {
        return web_hid_write(open->number, report.data(), static_cast<int>(report.size())) != 0;
    };
    port.read = [open](int wait_ms) { return open->read(wait_ms); };
    port.feature = [open](int report, std::size_t bytes) { return open->feature(report, bytes); };
    port.is_there = [path] { return web_hid_has(path.c_str()) != 0; };
    port.set_emergency_packet = [open](std::span<const std::uint8_t> packet) {
        web_hid_rest_with(open->number, packet.data(), static_cast<int>(packet.size()));
    };
    return port;
}

std::vector<HidNode> hid_nodes() {
    if (!hid_fault().empty()) return {};
    const std::unique_ptr<char, void (*)(void*)> list(web_hid_list(), std::free);
    std::vector<HidNode> nodes;
    std::istringstream lines{std::string(list.get())};
    HidNode node;
    int is_bluetooth = 0;
    while (lines >> node.path >> node.vendor >> node.product >> is_bluetooth) {
        node.is_bluetooth = is_bluetooth != 0;
        nodes.push_back(node);
    }
    return nodes;
}

NodeAccess access_to_node(const std::string& path) {
    return web_hid_has(path.c_str()) != 0 ? NodeAccess::allowed : NodeAccess::gone;
}

std::string driver_of_node(const std::string&) { return {}; }

Packet descriptor_of_node(const std::string&) { return {}; }

std::string hid_fault() {
    if (web_hid_is_there() == 0) {
        return "This browser reaches no game controllers: Chrome, Edge and Opera do, by WebHID.";
    }
    if (!has_threads()) {
        return "Game controllers are played on by the page from a server, or by tactspace itself: "
               "a page from the disk has no threads to pace them.";
    }
    return {};
}

std::function<void()> hid_request(std::span<const HidKind> kinds) {
    if (!hid_fault().empty()) return nullptr;
    std::vector<std::uint16_t> numbers;
    for (const HidKind& kind : kinds) {
        numbers.push_back(kind.vendor);
        numbers.push_back(kind.product);
    }
    return [numbers = std::move(numbers)] {
        web_hid_ask(numbers.data(), static_cast<int>(numbers.size() / 2));
    };
}

void watch_hid_nodes(std::function<void()> changed) {
    if (!hid_fault().empty()) return;
    {
        const std::lock_guard lock(web_ports().mutex);
        web_ports().changed = std::move(changed);
    }
    web_hid_watch();
}

}  // namespace tact
