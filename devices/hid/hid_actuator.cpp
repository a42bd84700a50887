#include "devices/hid/hid_actuator.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "devices/hid/haptic_page.h"
#include "devices/hid/hid_port.h"

namespace tact {

namespace {

struct Known {
    std::uint16_t vendor;
    std::uint16_t product;
    const char* name;
    ActuatorKind kind;
};

constexpr std::array kKnown{
    Known{0x057e, 0x2006, "Joy-Con (L)", ActuatorKind::joy_con},
    Known{0x057e, 0x2007, "Joy-Con (R)", ActuatorKind::joy_con},
    Known{0x057e, 0x200e, "Joy-Con in its grip", ActuatorKind::joy_con},
    Known{0x057e, 0x2009, "Switch Pro Controller", ActuatorKind::switch_pro},
    Known{0x054c, 0x05c4, "DualShock 4", ActuatorKind::dualshock_4},
    Known{0x054c, 0x09cc, "DualShock 4", ActuatorKind::dualshock_4},
    Known{0x054c, 0x0ba0, "DualShock 4 by its dongle", ActuatorKind::dualshock_4},
    Known{0x054c, 0x0ce6, "DualSense", ActuatorKind::dualsense},
    Known{0x054c, 0x0df2, "DualSense Edge", ActuatorKind::dualsense},
};

std::string hexadecimal(std::uint16_t number, bool upper) {
    char text[8];
    std::snprintf(text, sizeof text, upper ? "%04X" : "%04x", number);
    return text;
}

// What a listed node is, if it is anything that vibrates.
std::optional<HidActuator> actuator_at(const HidNode& node) {
    HidActuator actuator;
    actuator.bus = node.is_bluetooth ? HidBus::bluetooth : HidBus::usb;
    actuator.path = node.path;
    actuator.serial = node.serial;
    actuator.vendor = node.vendor;
    actuator.product = node.product;
    actuator.kernel_driver = driver_of_node(node.path);
    const auto known = std::ranges::find_if(kKnown, [&node](const Known& each) {
        return each.vendor == node.vendor && each.product == node.product;
    });
    if (known != kKnown.end()) {
        actuator.kind = known->kind;
        actuator.name = known->name;
        return actuator;
    }
    actuator.descriptor = descriptor_of_node(node.path);
    if (!haptic_page(actuator.descriptor)) return std::nullopt;
    actuator.kind = ActuatorKind::simple_haptic;
    actuator.name = node.name.empty() ? traits(actuator.kind).name : node.name;
    return actuator;
}

}  // namespace

std::vector<HidActuator> hid_actuators() {
    std::vector<HidActuator> found;
    for (const HidNode& node : hid_nodes()) {
        if (auto actuator = actuator_at(node)) found.push_back(*std::move(actuator));
    }
    std::ranges::sort(found, [](const HidActuator& a, const HidActuator& b) {
        return a.name != b.name ? a.name < b.name : a.path < b.path;
    });
    return found;
}

std::function<void()> controller_request() {
    std::array<HidKind, kKnown.size()> kinds;
    std::ranges::transform(kKnown, kinds.begin(), [](const Known& each) {
        return HidKind{each.vendor, each.product};
    });
    return hid_request(kinds);
}

std::string lasting_id(const HidActuator& actuator) {
    return "hid:" + hexadecimal(actuator.vendor, false) + ":" +
           hexadecimal(actuator.product, false) + ":" +
           (actuator.serial.empty() ? actuator.path : actuator.serial);
}

std::string udev_rule(const HidActuator& actuator) {
    const std::string which =
        actuator.bus == HidBus::bluetooth
            ? "KERNELS==\"*" + hexadecimal(actuator.vendor, true) + ":*\""
            : "ATTRS{idVendor}==\"" + hexadecimal(actuator.vendor, false) + "\"";
    return "KERNEL==\"hidraw*\", " + which + ", TAG+=\"uaccess\"";
}

Expected<Done> may_be_opened(const HidActuator& actuator) {
    const NodeAccess access = access_to_node(actuator.path);
    if (access == NodeAccess::gone) {
        return Error{actuator.name + " is not there any more: connect it again"};
    }
    if (access == NodeAccess::allowed) return Done{};
    return Error{"no permission to use " + actuator.name + " (" + actuator.path +
                 "): put this line into /etc/udev/rules.d/70-tactspace.rules, then connect it "
                 "again: " +
                 udev_rule(actuator)};
}

double packet_period_s(const HidActuator& actuator) {
    // By the air packets go out every 15 ms at best, and Nintendo's drop the connection when they
    // come faster than they are taken.
    constexpr double kNintendoByAirS = 0.030;
    constexpr double kSonyByAirS = 0.020;
    const ActuatorTraits& about = traits(actuator.kind);
    const bool by_air = actuator.bus == HidBus::bluetooth;
    if (about.language == Language::two_bands) {
        return by_air ? kNintendoByAirS : traits(ActuatorKind::switch_pro).period_s;
    }
    return by_air ? std::max(kSonyByAirS, about.period_s) : about.period_s;
}

double frame_hop_s(const HidActuator& actuator) {
    constexpr double kSlack = 0.02;
    return (1.0 + kSlack) * packet_period_s(actuator);
}

}  // namespace tact
