#include "devices/rumble/actuator_kind.h"

#include <string>

namespace tact {

namespace {

constexpr const char* kTwoSines = "at most two tones at a time, 41-626 and 82-1253 Hz";
constexpr const char* kTwoMotors = "strength below and above 110 Hz, but no frequency";

constexpr std::array<ActuatorTraits, kActuatorKinds.size()> kTraits{{
    {"joy-con", "Joy-Con", kTwoSines, Language::two_bands, 0.030},
    {"switch-pro", "Switch Pro Controller", kTwoSines, Language::two_bands, 0.015},
    {"dualshock-4", "DualShock 4", kTwoMotors, Language::motor_pair, 0.015},
    {"dualsense", "DualSense as two motors", kTwoMotors, Language::motor_pair, 0.015},
    {"simple-haptic", "simple haptic controller", "strength alone, and no frequency",
     Language::intensity, 0.020},
    {"voice-coil", "voice coil", "the waveform within the coil's band", Language::waveform, 0.0},
    {"phone-web", "phone's browser", "strength as the share of time that it runs, and no frequency",
     Language::on_off, 0.001},
}};

}  // namespace

const ActuatorTraits& traits(ActuatorKind kind) { return kTraits[static_cast<std::size_t>(kind)]; }

Expected<ActuatorKind> actuator_kind_named(std::string_view key) {
    std::string keys;
    for (const ActuatorKind kind : kActuatorKinds) {
        if (key == traits(kind).key) return kind;
        keys += (keys.empty() ? "" : ", ") + std::string(traits(kind).key);
    }
    return Error{"there is no kind of device \"" + std::string(key) + "\": expected one of " +
                 keys};
}

}  // namespace tact
