// The addresses at which this computer can be reached by phones.
//
// Source    getifaddrs(3); private addresses of RFC 1918
// Left out  IPv6, as codes and typed addresses stay short; interfaces that are down; loopback
#pragma once

#include <string>
#include <vector>

namespace tact {

struct NetworkInterface {
    std::string name;     // "wlan0"
    std::string address;  // "192.168.1.23"

    bool operator==(const NetworkInterface&) const = default;
};

// Private IPv4 addresses by interface name; those of bridges and containers last.
std::vector<NetworkInterface> network_interfaces();

// 10/8, 172.16/12 or 192.168/16.
bool is_private_address(const std::string& ipv4);

}  // namespace tact
