// A pattern as a file of another program: what a writer is given, what it gives back, and how a
// format that is written is described.
//
// The folder of a format describes it so, and model/io/formats/formats.h has a row for each folder.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/io/effects/actuator_map.h"
#include "model/io/effects/effect_format.h"
#include "model/io/recordings/recording.h"
#include "model/io/recordings/wave_file.h"
#include "model/pattern/pattern.h"

namespace tact {

// What is written, in the order of formats.h.
enum class TargetFormat {
    haptic,
    ahap,
    ahap_pair,
    hjif,
    android_xml,
    android_kotlin,
    android_timings,
    hla,
    web,
    pulsar,
    he,
    openxr,
    wav,
    csv
};

// How samples are written.
struct SampledAs {
    double rate_hz = 48'000.0;                    // a whole number
    WaveEncoding encoding = WaveEncoding::int24;  // of WAV
    double full_scale_g = 0.0;  // of WAV, its sidecar says so; 0: full_scale_of the loudest

    bool operator==(const SampledAs&) const = default;
};

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

using WriteEffect = WrittenEffect (*)(const Pattern& pattern, const EffectTarget& target);

// A format has `write`, or for samples `write_samples` and `read_samples`.
struct TargetTraits {
    TargetFormat format{};
    const char* key = "";     // "android-xml"
    const char* title = "";   // "Android 16 envelope (XML)"
    const char* ending = "";  // of the file's name, with all that is behind the pattern's
    const char* beside = "";  // of a second file, which belongs to it; empty: none
    const char* map = "";  // a bundled actuator, where nobody chooses another; empty: it has none
    WriteEffect write = nullptr;
    // Patterns that begin together and sound at once, at least one; null: a file holds one pattern.
    WrittenEffect (*write_at_once)(std::span<const Pattern> patterns,
                                   const EffectTarget& target) = nullptr;

    // What comes back is what read_effects.h reads of the text, unless one of these says otherwise.
    WriteEffect write_readable = nullptr;  // what is read in its place, as it has no reader
    Expected<Effect> (*read_back)(const WrittenEffect& written, const EffectFile& file) = nullptr;
    std::optional<EffectsRead> (*join)(const EffectsRead& first,
                                       const EffectsRead& beside) = nullptr;

    // A waveform of any rate; `read_samples` gives it at the model's.
    WrittenEffect (*write_samples)(const Waveform& waveform, const EffectTarget& target) = nullptr;
    Expected<Recording> (*read_samples)(const WrittenEffect& written, const std::string& name,
                                        const EffectTarget& target) = nullptr;
};

}  // namespace tact
