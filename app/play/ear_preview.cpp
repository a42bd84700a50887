#include "app/play/ear_preview.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace tact {

Pattern for_ear(Pattern pattern) {
    for (Carrier& carrier : pattern.carriers) carrier.frequency_hz *= kEarFactor;
    for (FrequencyPoint& point : pattern.frequency_curve) point.frequency_hz *= kEarFactor;
    for (Transient& transient : pattern.transients) transient.frequency_hz *= kEarFactor;
    return pattern;
}

LayeredPattern for_ear(LayeredPattern layered) {
    for (Layer& layer : layered.layers) {
        auto* pattern = std::get_if<Pattern>(&layer.source);
        if (pattern != nullptr) *pattern = for_ear(std::move(*pattern));
    }
    return layered;
}

std::optional<DeviceInfo> ear_output(const PlayState& play) {
    if (!play.listed || !play.audio) return std::nullopt;
    const auto is_output = [](const DeviceInfo& device) {
        return device.kind == DeviceKind::audio && device.trouble.empty();
    };
    constexpr std::array<std::string_view, 3> kBySystem{"/pulse", "/pipewire", "/default"};
    for (const std::string_view end : kBySystem) {
        const auto found = std::ranges::find_if(*play.listed, [&](const DeviceInfo& device) {
            return is_output(device) && device.id.ends_with(end);
        });
        if (found != play.listed->end()) return *found;
    }
    const auto any = std::ranges::find_if(*play.listed, is_output);
    return any == play.listed->end() ? std::nullopt : std::optional(*any);
}

}  // namespace tact
