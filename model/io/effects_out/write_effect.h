// A pattern as a file of another program, and in words what that loses.
//
// Pure: what is written depends on the arguments alone. Reading the text with the same actuator map
// (model/io/effects/read_effects.h) gives what is left of the pattern.
//
// Source    each format's at the head of its source file
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Output    UTF-8; a file that its owner takes: limits of points, times and steps are kept
// Left out  several patterns in one file; sounds.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/io/effects/actuator_map.h"
#include "model/pattern/pattern.h"

namespace tact {

enum class TargetFormat {
    haptic,
    ahap,
    ahap_continuous,  // of a pair: no control reaches the transients of the other
    ahap_transients,
    hjif,
    android_xml,
    android_kotlin,
    android_timings,
    hla,
    pulsar,
    he,
    openxr
};

struct TargetTraits {
    const char* key;     // "android-xml"
    const char* title;   // "an envelope of Android 16, XML"
    const char* ending;  // of the file's name, with all that is behind the pattern's
    const char* map;     // a bundled actuator, where nobody chooses another
};

std::span<const TargetTraits> target_formats();
const TargetTraits& traits(TargetFormat format);
std::optional<TargetFormat> target_format_of(std::string_view key);

struct EffectTarget {
    std::string name;  // of the pattern
    ActuatorMap map;
    std::string date = "2026-01-01";  // ISO 8601, for formats that have to have one
};

struct WrittenEffect {
    std::string text;
    std::vector<std::string> remarks;  // what was lost or changed; sentences without their stop

    bool operator==(const WrittenEffect&) const = default;
};

WrittenEffect write_effect(TargetFormat format, const Pattern& pattern, const EffectTarget& target);

// Steps of one amplitude each, 0 to 255, as Meta's converter takes them of a curve of 0 to 1: each
// stretch between jumps from its first value to its last, truncated in single precision; 0 only
// where a step is silent all through, as a motor that stops and starts is heard.
struct SteppedAmplitudes {
    std::vector<int> timings_ms;
    std::vector<int> amplitudes;
};
SteppedAmplitudes stepped(const AmplitudeCurve& intensity, double duration_s, double step_s);

}  // namespace tact
