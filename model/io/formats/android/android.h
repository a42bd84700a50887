// Android's vibrations: XML, calls of its builders in Kotlin, and timings with amplitudes as JSON.
// Hapticlabs' .hla has the same timings under other names.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

bool is_android_xml(std::string_view text);
Expected<Effects> read_android_xml(std::string_view text, const EffectFile& file);
WrittenEffect write_android_xml(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_android_kotlin(const Pattern& pattern, const EffectTarget& target);

Likeness android_timings_likeness(const Json& document, std::string_view path);
Likeness hla_likeness(const Json& document, std::string_view path);
Expected<Effects> read_timings(const Json& document, const EffectFile& file);  // of both
WrittenEffect write_android_timings(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_hla(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kAndroidFormats{EffectFormat{.key = "hla",
                                                         .name = "Hapticlabs .hla",
                                                         .map = "android",
                                                         .ending = ".hla",
                                                         .likeness = hla_likeness,
                                                         .read = read_timings},
                                            EffectFormat{.key = "android",
                                                         .name = "Android",
                                                         .map = "android",
                                                         .likeness = android_timings_likeness,
                                                         .read = read_timings,
                                                         .is_xml = is_android_xml,
                                                         .read_xml = read_android_xml}};

inline constexpr std::array kAndroidTargets{TargetTraits{.format = TargetFormat::android_xml,
                                                         .key = "android-xml",
                                                         .title = "Android 16 envelope (XML)",
                                                         .ending = ".xml",
                                                         .map = "android",
                                                         .write = write_android_xml},
                                            TargetTraits{.format = TargetFormat::android_kotlin,
                                                         .key = "android-kotlin",
                                                         .title = "Android 16 envelope (Kotlin)",
                                                         .ending = ".kt",
                                                         .map = "android",
                                                         .write = write_android_kotlin,
                                                         .write_readable = write_android_xml},
                                            TargetTraits{.format = TargetFormat::android_timings,
                                                         .key = "android-timings",
                                                         .title = "Android timings and amplitudes",
                                                         .ending = ".json",
                                                         .map = "android",
                                                         .write = write_android_timings},
                                            TargetTraits{.format = TargetFormat::hla,
                                                         .key = "hla",
                                                         .title = "Hapticlabs .hla",
                                                         .ending = ".hla",
                                                         .map = "android",
                                                         .write = write_hla}};

}  // namespace tact
