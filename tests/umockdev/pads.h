// A pad of every kind that is driven, each with its node.
#pragma once

#include "tests/support/haptic_descriptor.h"
#include "tests/umockdev/mock_bench.h"

namespace tact {

inline MockPad joy_con() { return {"hidraw0", true, 0x057e, 0x2006, "Joy-Con (L)", ""}; }
inline MockPad pro() { return {"hidraw1", false, 0x057e, 0x2009, "Nintendo Pro Controller", ""}; }
inline MockPad dualshock() {
    return {"hidraw2", true, 0x054c, 0x09cc, "Wireless Controller", "sony"};
}

inline MockPad dualsense() {
    MockPad pad{"hidraw3", false, 0x054c, 0x0ce6, "DualSense", "playstation"};
    pad.feature.resize(64);
    pad.feature[0] = 0x20;
    pad.feature[44] = 0x24;  // firmware 2.24
    pad.feature[45] = 0x02;
    return pad;
}

inline MockPad knob() {
    MockPad pad{"hidraw4", false, 0x1209, 0x0001, "Haptic knob", "hid-generic"};
    pad.descriptor.assign(kHapticDescriptor.begin(), kHapticDescriptor.end());
    pad.feature = {1, 0x04, 0x10, 0x05, 0x10};  // ordinal 3 buzzes, ordinal 4 rumbles
    return pad;
}

}  // namespace tact
