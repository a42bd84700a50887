// A pattern as a file of another program, and in words what that loses.
//
// Pure: what is written depends on the arguments alone. Reading the text with the same actuator map
// (model/io/effects/read_effects.h) gives what is left of the pattern. WAV and CSV hold samples, in
// g: they need no map, and hold recordings, too.
// How far off that is, in dB, is measured behind all writers: model/export/envelope_error.h.
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
#include "model/io/recordings/wave_file.h"
#include "model/pattern/pattern.h"

namespace tact {

enum class TargetFormat {
    haptic,
    ahap,
    ahap_pair,  // two files: no control of one reaches the transients of the other
    hjif,
    android_xml,
    android_kotlin,
    android_timings,
    hla,
    web,  // on-off times alone: phones' browsers
    pulsar,
    he,
    openxr,
    wav,
    csv
};

struct TargetTraits {
    const char* key;     // "android-xml"
    const char* title;   // "Android 16 envelope (XML)"
    const char* ending;  // of the file's name, with all that is behind the pattern's
    const char* beside;  // of a second file, which belongs to it; empty: none
    const char* map;     // a bundled actuator, where nobody chooses another; empty: it has none
};

std::span<const TargetTraits> target_formats();
const TargetTraits& traits(TargetFormat format);
std::optional<TargetFormat> target_format_of(std::string_view key);

// Samples: WAV or CSV.
bool is_sampled(TargetFormat format);

// How samples are written.
struct SampledAs {
    double rate_hz = 48'000.0;                    // a whole number
    WaveEncoding encoding = WaveEncoding::int24;  // of WAV
    double full_scale_g = 0.0;  // of WAV, its sidecar says so; 0: full_scale_of the loudest

    bool operator==(const SampledAs&) const = default;
};

// The least full scale that holds a peak at each of its whole-number steps; 1 g of silence.
double full_scale_of(double peak_g, WaveEncoding encoding);

struct EffectTarget {
    std::string name;  // of the pattern
    ActuatorMap map{};
    std::string date = "2026-01-01";  // ISO 8601, for formats that have to have one
    SampledAs sampled{};
};

// Sentences are without their stop.
struct WrittenEffect {
    std::string text;
    std::vector<std::string> remarks;   // what was lost or changed
    std::string beside{};               // the second file, of formats that have one
    std::vector<std::string> coarse{};  // what was rounded, thinned or ramped: said where it costs

    bool operator==(const WrittenEffect&) const = default;
};

WrittenEffect write_effect(TargetFormat format, const Pattern& pattern, const EffectTarget& target);

// Patterns that begin together and sound at once: in HJIF, which holds them as bands. Asserts that
// there is one.
WrittenEffect write_at_once(std::span<const Pattern> patterns, const EffectTarget& target);

// A waveform of any rate, of the sampled formats. A peak above the full scale is turned down, with
// a remark.
WrittenEffect write_samples(TargetFormat format, const Waveform& waveform,
                            const EffectTarget& target);

// Steps of one amplitude each, 0 to 255, of a curve of 0 to 1. What is flat is one step, rounded to
// a whole ms and to 1/255, silence 0. A slope from its first value to its last is in steps of
// `step_s`, as Meta's converter takes them: truncated in single precision, never 0, as a motor that
// stops and starts is heard. Neighbours of one amplitude are one step.
struct SteppedAmplitudes {
    std::vector<int> timings_ms;
    std::vector<int> amplitudes;
};
SteppedAmplitudes stepped(const AmplitudeCurve& intensity, double duration_s, double step_s);

}  // namespace tact
