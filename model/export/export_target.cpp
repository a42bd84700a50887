#include "model/export/export_target.h"

#include <algorithm>
#include <cmath>

#include "model/io/formats/read_effects.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::string format_keys() {
    std::string keys;
    for (const TargetTraits& one : target_formats())
        keys += (keys.empty() ? "" : ", ") + std::string(one.key);
    return keys;
}

std::string rate_words(double rate_hz) {
    return grouped_digits(static_cast<std::size_t>(std::llround(rate_hz))) + " Hz";
}

const char* words_of(WaveEncoding encoding) {
    if (encoding == WaveEncoding::float32) return "floats";
    return encoding == WaveEncoding::int16 ? "16 bits" : "24 bits";
}

}  // namespace

ExportTarget own_target(TargetFormat format) {
    if (is_sampled(format)) {
        ExportTarget target{format};
        if (format == TargetFormat::csv) target.sampled.rate_hz = kModelRateHz;
        return target;
    }
    return {format, bundled_actuator(traits(format).map)};
}

ExportTarget usual_target(TargetFormat format, const PatternSet& set) {
    ExportTarget target = own_target(format);
    if (is_sampled(format)) return target;
    const EffectOrigin* read_by = nullptr;
    for (const Vibration& one : set.vibrations) {
        if (one.effect.actuator.empty()) continue;
        if (read_by != nullptr && read_by->actuator != one.effect.actuator) return target;
        const EffectFormat* from = format_named(one.effect.format);
        if (from != nullptr && one.effect.actuator == from->map) return target;
        read_by = &one.effect;
    }
    if (read_by == nullptr) return target;
    const auto known =
        std::ranges::find(bundled_actuators(), read_by->actuator, &ActuatorMap::name);
    if (known != bundled_actuators().end()) target.map = *known;
    return target;
}

Expected<ExportTarget> export_target_named(const std::string& format, const std::string& actuator) {
    const auto known = target_format_of(format);
    if (!known) {
        return Error{"\"" + format + "\": expected a format that is written, one of " +
                     format_keys()};
    }
    if (actuator.empty()) return own_target(*known);
    if (is_sampled(*known)) {
        return Error{"\"" + actuator + "\": expected no actuator, " + format + " holds g"};
    }
    const Expected<ActuatorMap> map = actuator_named(actuator);
    if (!map) return map.error();
    return ExportTarget{*known, *map};
}

Expected<ExportTarget> export_target_named(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == text.npos) return export_target_named(text, "");
    if (colon + 1 == text.size())
        return Error{"\"" + text + "\": expected an actuator behind \":\""};
    return export_target_named(text.substr(0, colon), text.substr(colon + 1));
}

std::string words_on(const ExportTarget& target) {
    if (is_sampled(target.format)) {
        const bool csv = target.format == TargetFormat::csv;
        const std::string bits =
            csv ? "" : std::string(" and ") + words_of(target.sampled.encoding);
        return std::string("as ") + traits(target.format).title + " of " +
               rate_words(target.sampled.rate_hz) + bits + " holds them";
    }
    return std::string("as ") + traits(target.format).title + " for " + target.map.name +
           " holds them";
}

std::string meaning_of(const ExportTarget& target) {
    if (target.format == TargetFormat::csv) return "times in s, accelerations in g";
    if (target.format != TargetFormat::wav) {
        return "actuator " + target.map.name + ": " + target.map.source;
    }
    const double full_g = target.sampled.full_scale_g;
    const std::string full =
        full_g > 0.0 ? significant_digits(full_g, 6) + " g" : "as the loudest of all";
    return "full scale: " + full + ", said in the .wav.json beside each file";
}

}  // namespace tact
