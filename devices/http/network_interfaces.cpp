#include "devices/http/network_interfaces.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <tuple>

namespace tact {

namespace {

std::optional<NetworkInterface> private_interface(const ifaddrs& entry) {
    const bool is_up = (entry.ifa_flags & IFF_UP) != 0 && (entry.ifa_flags & IFF_RUNNING) != 0;
    if (entry.ifa_addr == nullptr || entry.ifa_addr->sa_family != AF_INET || !is_up) return {};
    sockaddr_in address{};
    std::memcpy(&address, entry.ifa_addr, sizeof address);
    char text[INET_ADDRSTRLEN];
    if (inet_ntop(AF_INET, &address.sin_addr, text, sizeof text) == nullptr) return {};
    return is_private_address(text) ? std::optional(NetworkInterface{entry.ifa_name, text})
                                    : std::nullopt;
}

// One of containers or virtual machines: no phone is there.
bool is_inside(const NetworkInterface& which) {
    constexpr std::array<std::string_view, 6> kBeginnings{"docker", "br-",   "veth",
                                                          "virbr",  "vmnet", "lxc"};
    return std::ranges::any_of(
        kBeginnings, [&](std::string_view begin) { return which.name.starts_with(begin); });
}

}  // namespace

bool is_private_address(const std::string& ipv4) {
    in_addr address{};
    if (inet_pton(AF_INET, ipv4.c_str(), &address) != 1) return false;
    const std::uint32_t bits = ntohl(address.s_addr);
    return bits >> 24U == 10 || bits >> 20U == ((172U << 4U) | 1U) ||
           bits >> 16U == ((192U << 8U) | 168U);
}

std::vector<NetworkInterface> network_interfaces() {
    std::vector<NetworkInterface> found;
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) != 0) return found;
    for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
        if (auto one = private_interface(*entry)) found.push_back(*std::move(one));
    }
    freeifaddrs(all);
    std::ranges::sort(found, {}, [](const NetworkInterface& each) {
        return std::tuple(is_inside(each), each.name, each.address);
    });
    return found;
}

}  // namespace tact
