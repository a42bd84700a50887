#include "model/io/effects_out/write_effect.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>

#include "model/io/effects/ahap_pair.h"
#include "model/io/effects/read_effects.h"
#include "model/io/effects_out/writers.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

constexpr std::array<TargetTraits, 14> kTargets{
    {{"haptic", "Meta .haptic", ".haptic", "", "quest"},
     {"ahap", "AHAP", ".ahap", "", "core-haptics"},
     {"ahap-pair", "AHAP in two files", kContinuousEnding, kTransientsEnding, "core-haptics"},
     {"hjif", "MPEG HJIF", ".hjif", "", "mpeg"},
     {"android-xml", "Android 16 envelope (XML)", ".xml", "", "android"},
     {"android-kotlin", "Android 16 envelope (Kotlin)", ".kt", "", "android"},
     {"android-timings", "Android timings and amplitudes", ".json", "", "android"},
     {"hla", "Hapticlabs .hla", ".hla", "", "android"},
     {"web", "Web vibration (phones' browsers)", kVibrateEnding, "", "phone-web"},
     {"pulsar", "Pulsar preset", ".json", "", "core-haptics"},
     {"he", "RichTap .he", ".he", "", "richtap"},
     {"openxr", "XR_EXT_haptic_parametric (C)", ".c", "", "quest"},
     {"wav", "WAV", ".wav", ".wav.json", ""},
     {"csv", "CSV of accelerations", ".csv", "", ""}}};

}  // namespace

std::span<const TargetTraits> target_formats() { return kTargets; }

const TargetTraits& traits(TargetFormat format) {
    return kTargets[static_cast<std::size_t>(format)];
}

std::optional<TargetFormat> target_format_of(std::string_view key) {
    const auto found = std::ranges::find(kTargets, key, &TargetTraits::key);
    if (found == kTargets.end()) return std::nullopt;
    return static_cast<TargetFormat>(found - kTargets.begin());
}

bool is_sampled(TargetFormat format) {
    return format == TargetFormat::wav || format == TargetFormat::csv;
}

WrittenEffect write_effect(TargetFormat format, const Pattern& own, const EffectTarget& target) {
    const Pattern pattern = with_drawn_pitches(own);
    switch (format) {
        case TargetFormat::haptic:
            return write_haptic(pattern, target);
        case TargetFormat::ahap:
            return write_ahap(pattern, target);
        case TargetFormat::ahap_pair:
            return write_ahap_pair(pattern, target);
        case TargetFormat::hjif:
            return write_hjif(pattern, target);
        case TargetFormat::android_xml:
            return write_android_xml(pattern, target);
        case TargetFormat::android_kotlin:
            return write_android_kotlin(pattern, target);
        case TargetFormat::android_timings:
            return write_android_timings(pattern, target);
        case TargetFormat::hla:
            return write_hla(pattern, target);
        case TargetFormat::web:
            return write_web(pattern, target);
        case TargetFormat::pulsar:
            return write_pulsar(pattern, target);
        case TargetFormat::he:
            return write_he(pattern, target);
        case TargetFormat::openxr:
            return write_openxr(pattern, target);
        case TargetFormat::wav:
        case TargetFormat::csv:
            return write_samples(format, render(pattern, target.sampled.rate_hz), target);
    }
    assert(false && "a format that is written");
    return {};
}

std::string printed(const Json& document) { return text_of_json(document, 2) + "\n"; }

std::string identifier(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        result += letter || (c >= '0' && c <= '9') ? c : '_';
    }
    const bool starts = !result.empty() && !(result.front() >= '0' && result.front() <= '9');
    return starts ? result : "effect_" + result;
}

}  // namespace tact
