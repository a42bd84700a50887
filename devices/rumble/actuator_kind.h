// The kinds of actuators that differ in what of a vibration they keep.
#pragma once

#include <array>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

enum class ActuatorKind {
    joy_con,        // HD rumble over Bluetooth
    switch_pro,     // HD rumble over a cable: twice as many packets a second
    dualshock_4,    // two motors
    dualsense,      // imitates two motors; its actuators themselves are a sound card
    simple_haptic,  // an intensity alone, by the haptics page of HID
    voice_coil,     // at an audio output: the waveform itself, within the coil's band
    phone_web       // on or off alone: a page in a phone's browser
};

inline constexpr std::array<ActuatorKind, 7> kActuatorKinds{
    ActuatorKind::joy_con,   ActuatorKind::switch_pro,    ActuatorKind::dualshock_4,
    ActuatorKind::dualsense, ActuatorKind::simple_haptic, ActuatorKind::voice_coil,
    ActuatorKind::phone_web};

// How it is asked to vibrate.
enum class Language { two_bands, motor_pair, intensity, waveform, on_off };

struct ActuatorTraits {
    const char* key;    // as on the command line: joy-con
    const char* name;   // Joy-Con
    const char* keeps;  // what of a vibration gets through, in a few words
    Language language;
    double period_s;  // between what it is told; 0: it is told every sample
};

const ActuatorTraits& traits(ActuatorKind kind);

// By its key. An Error lists the keys.
Expected<ActuatorKind> actuator_kind_named(std::string_view key);

}  // namespace tact
