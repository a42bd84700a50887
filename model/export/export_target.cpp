#include "model/export/export_target.h"

namespace tact {

namespace {

std::string format_keys() {
    std::string keys;
    for (const TargetTraits& one : target_formats())
        keys += (keys.empty() ? "" : ", ") + std::string(one.key);
    return keys;
}

}  // namespace

ExportTarget own_target(TargetFormat format) {
    return {format, bundled_actuator(traits(format).map)};
}

Expected<ExportTarget> export_target_named(const std::string& format, const std::string& actuator) {
    const auto known = target_format_of(format);
    if (!known) {
        return Error{"\"" + format + "\": expected a format that is written, one of " +
                     format_keys()};
    }
    if (actuator.empty()) return own_target(*known);
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
    return std::string("as ") + traits(target.format).title + " for " + target.map.name +
           " holds them";
}

}  // namespace tact
